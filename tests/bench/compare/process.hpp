// Runs a program and keeps what it prints.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace bozzetto::compare {

/// Standard output of the program, which inherits standard error; nothing when it failed, which is
/// told on standard error.
std::optional<std::string> outputOf(const std::filesystem::path& program,
                                    const std::vector<std::string>& arguments);

}  // namespace bozzetto::compare
