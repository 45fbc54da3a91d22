// Reference-counted blocks: shared ones are immutable, the only holder may write (copy-on-write).
#pragma once
#include <atomic>
#include <cstdint>
#include <utility>

namespace bozzetto {

/// What a block carries for its holders. `editor` is the number of the edit that made it and may
/// write it in place until it commits; 0 = nobody.
class RefCounted {
 public:
  RefCounted() = default;
  RefCounted(const RefCounted&) {}  // a copy starts without holders, unsettled
  RefCounted& operator=(const RefCounted&) { return *this; }

  /// Acquires: whoever finds itself the only holder may write what others have read.
  std::uint32_t holders() const { return holders_.load(std::memory_order_acquire); }
  std::uint64_t editor = 0;
  /// Whoever wrote the block last left it as canonical() would; cleared when it is handed out to be
  /// written.
  bool settled = false;

 private:
  template <class T>
  friend class Ref;
  mutable std::atomic<std::uint32_t> holders_{0};
};

/// A counted pointer, 8 bytes. Copying is one relaxed atomic increment.
template <class T>
class Ref {
 public:
  Ref() = default;
  Ref(std::nullptr_t) {}  // NOLINT(google-explicit-constructor): reads as a pointer
  explicit Ref(T* block) : block_(block) { hold(); }
  Ref(const Ref& other) : block_(other.block_) { hold(); }
  Ref(Ref&& other) noexcept : block_(std::exchange(other.block_, nullptr)) {}
  Ref& operator=(Ref other) noexcept {
    std::swap(block_, other.block_);
    return *this;
  }
  ~Ref() { release(); }

  T* get() const { return block_; }
  T& operator*() const { return *block_; }
  T* operator->() const { return block_; }
  explicit operator bool() const { return block_ != nullptr; }
  friend bool operator==(const Ref& a, const Ref& b) { return a.block_ == b.block_; }

 private:
  void hold() const {
    if (block_ != nullptr) block_->holders_.fetch_add(1, std::memory_order_relaxed);
  }
  void release() {
    if (block_ != nullptr && block_->holders_.fetch_sub(1, std::memory_order_acq_rel) == 1) {
      delete block_;
    }
  }

  T* block_ = nullptr;
};

}  // namespace bozzetto
