#include "bozzetto/grid/block_pool.hpp"

#include <sys/mman.h>

#include <cassert>
#include <cstdint>
#include <mutex>
#include <new>

#include "bozzetto/base/memory.hpp"

namespace bozzetto {

#ifdef BOZZETTO_SANITIZED

// The address sanitizer watches plain allocations only.
void* allocateBlock(std::size_t size) { return ::operator new (size, std::align_val_t{64}); }
void releaseBlock(void* block, std::size_t) noexcept {
  ::operator delete (block, std::align_val_t{64});
}

#else

namespace {

constexpr std::size_t kSlabBytes = std::size_t{32} << 20;
constexpr std::size_t kHugePage = std::size_t{2} << 20;
// With less than this the system would soon kill the program, or another one.
constexpr std::uint64_t kLeftToOthers = std::uint64_t{384} << 20;

// A free list over slabs that are never unmapped: what a sculptor used once is used again.
class Pool {
 public:
  explicit Pool(std::size_t pieceBytes) : pieceBytes_((pieceBytes + 63) / 64 * 64) {}

  void* take() {
    const std::lock_guard lock(mutex_);
    if (free_ != nullptr) {
      Piece* piece = free_;
      free_ = piece->next;
      return piece;
    }
    if (left_ < pieceBytes_) mapSlab();
    void* piece = next_;
    next_ += pieceBytes_;
    left_ -= pieceBytes_;
    return piece;
  }

  void giveBack(void* block) {
    const std::lock_guard lock(mutex_);
    free_ = new (block) Piece{free_};
  }

 private:
  struct Piece {
    Piece* next;
  };

  void mapSlab() {
    if (availableMemory().value_or(UINT64_MAX) < kLeftToOthers) throw std::bad_alloc();
    void* raw = ::mmap(nullptr, kSlabBytes + kHugePage, PROT_READ | PROT_WRITE,
                       MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (raw == MAP_FAILED) throw std::bad_alloc();
    auto address = reinterpret_cast<std::uintptr_t>(raw);
    address = (address + kHugePage - 1) / kHugePage * kHugePage;
    next_ = reinterpret_cast<std::byte*>(address);
    left_ = kSlabBytes;
    ::madvise(next_, left_, MADV_HUGEPAGE);
  }

  const std::size_t pieceBytes_;
  std::mutex mutex_;
  Piece* free_ = nullptr;
  std::byte* next_ = nullptr;
  std::size_t left_ = 0;
};

// One pool per 64-byte size class; small blocks (side 1) get along with the general allocator.
constexpr std::size_t kSmallest = 512, kLargest = 16384;

Pool& poolFor(std::size_t size) {
  static Pool* const pools = [] {
    constexpr std::size_t count = kLargest / 64 + 1;
    auto* made = static_cast<Pool*>(::operator new(count * sizeof(Pool)));
    for (std::size_t n = 0; n < count; ++n) new (made + n) Pool(n * 64);
    return made;  // lives as long as the last static object that holds a block
  }();
  return pools[(size + 63) / 64];
}

bool pooled(std::size_t size) { return size >= kSmallest && size <= kLargest; }

}  // namespace

void* allocateBlock(std::size_t size) {
  return pooled(size) ? poolFor(size).take() : ::operator new (size, std::align_val_t{64});
}

void releaseBlock(void* block, std::size_t size) noexcept {
  if (pooled(size)) {
    poolFor(size).giveBack(block);
  } else {
    ::operator delete (block, std::align_val_t{64});
  }
}

#endif

}  // namespace bozzetto
