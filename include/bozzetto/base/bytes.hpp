// Explicit little-endian bytes: the only way numbers get into and out of files. Every read checks
// what remains first.
#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "bozzetto/base/error.hpp"

namespace bozzetto {

using Bytes = std::vector<std::byte>;

namespace detail {
template <class T>
concept Number = std::is_arithmetic_v<T>;

template <Number T>
T littleEndian(T value) {
  if constexpr (std::endian::native == std::endian::big && sizeof(T) > 1) {
    std::byte raw[sizeof(T)], swapped[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    for (std::size_t n = 0; n < sizeof(T); ++n) swapped[n] = raw[sizeof(T) - 1 - n];
    std::memcpy(&value, swapped, sizeof(T));
  }
  return value;
}
}  // namespace detail

/// Appends numbers and raw bytes to a growing buffer.
class ByteWriter {
 public:
  template <detail::Number T>
  void put(T value) {
    value = detail::littleEndian(value);
    const auto* raw = reinterpret_cast<const std::byte*>(&value);
    bytes_.insert(bytes_.end(), raw, raw + sizeof(T));
  }
  void put(std::span<const std::byte> raw) { bytes_.insert(bytes_.end(), raw.begin(), raw.end()); }
  void put(std::string_view text) { put(std::as_bytes(std::span(text.data(), text.size()))); }

  const Bytes& bytes() const { return bytes_; }
  Bytes take() { return std::move(bytes_); }

 private:
  Bytes bytes_;
};

/// Reads numbers from a buffer it does not own; throws Error past the end. `name` opens the text.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes, std::string_view name = "data")
      : bytes_(bytes), name_(name) {}

  template <detail::Number T>
  T get() {
    T value;
    std::memcpy(&value, take(sizeof(T)).data(), sizeof(T));
    return detail::littleEndian(value);
  }

  /// The next `count` bytes, as a view into the buffer.
  std::span<const std::byte> take(std::size_t count) {
    if (count > remaining()) throwShort(count);
    const auto part = bytes_.subspan(position_, count);
    position_ += count;
    return part;
  }

  void skip(std::size_t count) { take(count); }
  std::size_t position() const { return position_; }
  std::size_t remaining() const { return bytes_.size() - position_; }

 private:
  [[noreturn]] void throwShort(std::size_t wanted) const {
    throw Error(std::string(name_) + ": ends at byte " + std::to_string(bytes_.size()) + ", " +
                std::to_string(wanted) + " bytes expected at byte " + std::to_string(position_));
  }

  std::span<const std::byte> bytes_;
  std::string_view name_;
  std::size_t position_ = 0;
};

}  // namespace bozzetto
