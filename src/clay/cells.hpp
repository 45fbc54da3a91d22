// Arrays over the box of a region. Zero at first, and costing memory only where they are written:
// boxes are mostly air.
#pragma once
#include <cstddef>
#include <type_traits>
#include <utility>

namespace bozzetto::clay {

/// So many bytes of zeros; throws std::bad_alloc. Straight from the system, for calloc would write
/// zeros over memory that it has had before.
void* zeroPages(std::size_t bytes);
void givePagesBack(void* pages, std::size_t bytes) noexcept;

template <class T>
class Cells {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  Cells() = default;
  explicit Cells(std::size_t count)
      : bytes_((count == 0 ? 1 : count) * sizeof(T)), data_(static_cast<T*>(zeroPages(bytes_))) {}
  Cells(Cells&& other) noexcept
      : bytes_(std::exchange(other.bytes_, 0)), data_(std::exchange(other.data_, nullptr)) {}
  Cells& operator=(Cells&& other) noexcept {
    swap(*this, other);
    return *this;
  }
  ~Cells() {
    if (data_ != nullptr) givePagesBack(data_, bytes_);
  }

  T& operator[](std::size_t n) { return data_[n]; }
  const T& operator[](std::size_t n) const { return data_[n]; }
  T* data() { return data_; }
  const T* data() const { return data_; }
  explicit operator bool() const { return data_ != nullptr; }
  friend void swap(Cells& a, Cells& b) noexcept {
    std::swap(a.data_, b.data_);
    std::swap(a.bytes_, b.bytes_);
  }

 private:
  std::size_t bytes_ = 0;
  T* data_ = nullptr;
};

}  // namespace bozzetto::clay
