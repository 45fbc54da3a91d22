// Whole files in, whole files out. Writing never leaves half a file under the real name.
#pragma once
#include <cstddef>
#include <filesystem>
#include <span>

#include "bozzetto/base/bytes.hpp"

namespace bozzetto {

/// The whole file. Throws Error naming the path when it is missing, unreadable, not a regular file
/// or longer than `limit` bytes.
Bytes readFile(const std::filesystem::path& path, std::size_t limit = std::size_t{1} << 40);

/// Writes to a temporary name in the same folder, syncs, renames, syncs the folder. On any failure
/// throws Error and leaves whatever stood at `path` untouched. "-" and /dev/stdout write to
/// standard output.
void writeFile(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// True for "-" and /dev/stdout.
bool isStandardOutput(const std::filesystem::path& path);

}  // namespace bozzetto
