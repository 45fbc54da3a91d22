// XXH3, 64 bits: checks in files, results in tests, names of fields.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace bozzetto {

std::uint64_t hash64(std::span<const std::byte> bytes);

/// The same hash over bytes that come in pieces.
class Hasher {
 public:
  Hasher();
  ~Hasher();
  Hasher(const Hasher&) = delete;
  Hasher& operator=(const Hasher&) = delete;
  void add(std::span<const std::byte> bytes);
  std::uint64_t result() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// 16 lower-case hexadecimal digits.
std::string hexDigits(std::uint64_t value);

}  // namespace bozzetto
