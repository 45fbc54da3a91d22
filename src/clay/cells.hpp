// Arrays over the box of a region. Zero at first, and costing memory only where they are written:
// boxes are mostly air.
#pragma once
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace bozzetto::clay {

template <class T>
class Cells {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  Cells() = default;
  explicit Cells(std::size_t count)
      : data_(static_cast<T*>(std::calloc(count == 0 ? 1 : count, sizeof(T)))) {
    if (!data_) throw std::bad_alloc();
  }

  T& operator[](std::size_t n) { return data_[n]; }
  const T& operator[](std::size_t n) const { return data_[n]; }
  T* data() { return data_.get(); }
  const T* data() const { return data_.get(); }
  explicit operator bool() const { return data_ != nullptr; }
  friend void swap(Cells& a, Cells& b) noexcept { a.data_.swap(b.data_); }

 private:
  struct Free {
    void operator()(T* data) const { std::free(data); }
  };
  std::unique_ptr<T[], Free> data_;
};

}  // namespace bozzetto::clay
