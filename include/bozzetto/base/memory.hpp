// What the machine has left: who asks for more is told so, instead of being killed by the system.
#pragma once
#include <cstdint>
#include <optional>
#include <string_view>

namespace bozzetto {

/// Bytes that can be taken now without swapping; nothing where the system does not tell. Reads a
/// file: for whoever takes megabytes at a time.
std::optional<std::uint64_t> availableMemory();

/// The same from the text of Linux's /proc/meminfo.
std::optional<std::uint64_t> availableMemory(std::string_view meminfo);

}  // namespace bozzetto
