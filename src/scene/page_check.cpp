#include "scene/page_check.hpp"

#include <algorithm>
#include <atomic>

#include "bozzetto/base/bytes.hpp"
#include "bozzetto/base/hash.hpp"
#include "bozzetto/base/parallel.hpp"

namespace bozzetto {
namespace {

constexpr std::size_t kContentBytes = kPageBytes - kPageCheckBytes;

// Over the page's content and its number (from 1), so that exchanged pages show.
std::uint64_t pageCheck(std::span<const std::byte> page, std::uint64_t number) {
  ByteWriter numbered;
  numbered.put(number);
  Hasher hasher;
  hasher.add(page.first(kContentBytes));
  hasher.add(numbered.bytes());
  return hasher.result();
}

bool holds(std::span<const std::byte> page, std::size_t number) {
  ByteReader check(page.subspan(kContentBytes));
  if (check.get<std::uint64_t>() == pageCheck(page, number)) return true;
  return std::all_of(page.begin(), page.end(), [](std::byte b) { return b == std::byte{0}; });
}

}  // namespace

void sealPage(std::span<std::byte, kPageBytes> page, std::uint64_t number) {
  ByteWriter check;
  check.put(pageCheck(page, number));
  std::copy(check.bytes().begin(), check.bytes().end(), page.begin() + kContentBytes);
}

std::optional<std::size_t> firstBadPage(std::span<const std::byte> file) {
  const std::size_t pages = file.size() / kPageBytes;
  std::atomic<std::size_t> first{pages};
  parallelFor(pages, 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      if (holds(file.subspan(n * kPageBytes, kPageBytes), n + 1)) continue;
      for (std::size_t least = first; n < least && !first.compare_exchange_weak(least, n);) {
      }
      return;
    }
  });
  return first == pages ? std::nullopt : std::optional(first + 1);
}

}  // namespace bozzetto
