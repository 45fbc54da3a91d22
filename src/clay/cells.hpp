// Arrays over the box of a region. Zero at first, and costing memory only where they are written:
// boxes are mostly air.
#pragma once
#include <type_traits>
#include <utility>

#include "clay/pages.hpp"

namespace bozzetto::clay {

template <class T>
class Cells {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  Cells() = default;
  explicit Cells(std::size_t count) : pages_(takePages(count * sizeof(T))) {}
  Cells(Cells&& other) noexcept : pages_(std::exchange(other.pages_, {})) {}
  Cells& operator=(Cells&& other) noexcept {
    swap(*this, other);
    return *this;
  }
  ~Cells() {
    if (pages_.data != nullptr) givePagesBack(pages_);
  }

  T& operator[](std::size_t n) { return data()[n]; }
  const T& operator[](std::size_t n) const { return data()[n]; }
  T* data() { return static_cast<T*>(pages_.data); }
  const T* data() const { return static_cast<const T*>(pages_.data); }
  explicit operator bool() const { return pages_.data != nullptr; }
  friend void swap(Cells& a, Cells& b) noexcept { std::swap(a.pages_, b.pages_); }

 private:
  Pages pages_;
};

}  // namespace bozzetto::clay
