#include "clay/pages.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <new>
#include <span>
#include <vector>

namespace bozzetto::clay {
namespace {

constexpr std::size_t kPage = 4096;
constexpr std::size_t kMostKept = 32u << 20;
constexpr std::size_t kWaste = 4;  // pages for a box are not taken for one so much smaller

std::size_t wholePages(std::size_t bytes) { return (bytes / kPage + 1) * kPage; }

// What the system says of every page of this process.
class PageMap {
 public:
  /// Of the pages from `first` on; false when it cannot be told.
  bool read(std::size_t first, std::span<std::uint64_t> entries) {
    if (owner_ != getpid()) {
      if (file_ >= 0) close(file_);
      file_ = open("/proc/self/pagemap", O_RDONLY | O_CLOEXEC);
      owner_ = getpid();
    }
    const std::size_t bytes = entries.size_bytes();
    const auto place = static_cast<off_t>(first * sizeof(std::uint64_t));
    return file_ >= 0 && pread(file_, entries.data(), bytes, place) == static_cast<ssize_t>(bytes);
  }

 private:
  int file_ = -1;
  pid_t owner_ = -1;  // a forked process has pages of its own
};

// A page that was only read is the system's one page of zeros: not to be written.
bool isZero(const std::byte* page) {
  std::uint64_t found = 0;
  for (std::size_t n = 0; n < kPage && found == 0; n += 512) {
    std::array<std::uint64_t, 64> words;
    std::memcpy(words.data(), page + n, sizeof words);
    for (const std::uint64_t word : words) found |= word;
  }
  return found == 0;
}

class Pool {
 public:
  Pages take(std::size_t bytes) {
    const std::lock_guard lock(mutex_);
    auto best = kept_.end();
    for (auto each = kept_.begin(); each != kept_.end(); ++each) {
      if (each->pages.bytes < bytes || each->pages.bytes > kWaste * bytes) continue;
      // Of equals the last: arrays are given back in the reverse of the order they are taken in.
      if (best == kept_.end() || each->pages.bytes <= best->pages.bytes) best = each;
    }
    if (best == kept_.end()) return {};
    const Kept found = *best;
    kept_.erase(best);
    written_ -= found.written;
    return found.pages;
  }

  // False when they are better given to the system.
  bool keep(Pages pages) {
    if (pages.bytes > kMostKept) return false;
    const std::lock_guard lock(mutex_);
    std::size_t written = 0;
    if (!clean(pages, written)) return false;
    kept_.push_back({pages, written});
    written_ += written;
    return true;
  }

 private:
  struct Kept {
    Pages pages;
    std::size_t written;  // bytes that are in memory
  };

  bool clean(Pages pages, std::size_t& written) {
    constexpr std::uint64_t there = std::uint64_t{3} << 62;  // in memory or swapped out
    const std::size_t first = reinterpret_cast<std::uintptr_t>(pages.data) / kPage;
    const std::size_t count = pages.bytes / kPage;
    entries_.resize(count);
    if (!map_.read(first, entries_)) return false;
    written = kPage * static_cast<std::size_t>(
                          std::count_if(entries_.begin(), entries_.end(),
                                        [](std::uint64_t entry) { return (entry & there) != 0; }));
    if (written_ + written > kMostKept) return false;
    for (std::size_t n = 0; n < count; ++n) {
      std::byte* page = static_cast<std::byte*>(pages.data) + n * kPage;
      if ((entries_[n] & there) != 0 && !isZero(page)) std::memset(page, 0, kPage);
    }
    return true;
  }

  std::mutex mutex_;
  std::vector<Kept> kept_;
  std::size_t written_ = 0;  // of all that are kept
  PageMap map_;
  std::vector<std::uint64_t> entries_;
};

// Never destroyed: arrays may outlive whatever main's end destroys.
Pool& pool() {
  static Pool* const pool = new Pool;
  return *pool;
}

}  // namespace

Pages takePages(std::size_t bytes) {
  const Pages kept = pool().take(bytes);
  if (kept.data != nullptr) return kept;
  const Pages fresh{nullptr, wholePages(bytes)};
  constexpr int kind = MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE;
  void* data = mmap(nullptr, fresh.bytes, PROT_READ | PROT_WRITE, kind, -1, 0);
  if (data == MAP_FAILED) throw std::bad_alloc();
  return {data, fresh.bytes};
}

void givePagesBack(Pages pages) noexcept {
  try {
    if (pool().keep(pages)) return;
  } catch (const std::bad_alloc&) {  // no room to note them
  }
  munmap(pages.data, pages.bytes);
}

}  // namespace bozzetto::clay
