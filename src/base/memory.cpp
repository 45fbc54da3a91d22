#include "bozzetto/base/memory.hpp"

#include <charconv>
#include <fstream>
#include <iterator>
#include <string>

namespace bozzetto {

std::optional<std::uint64_t> availableMemory(std::string_view meminfo) {
  constexpr std::string_view kName = "MemAvailable:";
  const std::size_t line = meminfo.find(kName);
  if (line == meminfo.npos) return std::nullopt;
  const std::size_t number = meminfo.find_first_not_of(' ', line + kName.size());
  if (number == meminfo.npos) return std::nullopt;
  std::uint64_t kibibytes = 0;
  const auto [end, error] =
      std::from_chars(meminfo.data() + number, meminfo.data() + meminfo.size(), kibibytes);
  if (error != std::errc() || kibibytes > UINT64_MAX / 1024) return std::nullopt;
  return kibibytes * 1024;
}

std::optional<std::uint64_t> availableMemory() {
  std::ifstream file("/proc/meminfo");
  return availableMemory(std::string(std::istreambuf_iterator<char>(file), {}));
}

}  // namespace bozzetto
