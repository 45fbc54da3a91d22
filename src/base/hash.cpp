#include "bozzetto/base/hash.hpp"

#include <xxhash.h>

#include <new>

namespace bozzetto {

std::uint64_t hash64(std::span<const std::byte> bytes) {
  return XXH3_64bits(bytes.data(), bytes.size());
}

struct Hasher::State {
  XXH3_state_t* raw = XXH3_createState();
  State() {
    if (raw == nullptr) throw std::bad_alloc();
    XXH3_64bits_reset(raw);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() { XXH3_freeState(raw); }
};

Hasher::Hasher() : state_(std::make_unique<State>()) {}
Hasher::~Hasher() = default;

void Hasher::add(std::span<const std::byte> bytes) {
  XXH3_64bits_update(state_->raw, bytes.data(), bytes.size());
}

std::uint64_t Hasher::result() const { return XXH3_64bits_digest(state_->raw); }

std::string hexDigits(std::uint64_t value) {
  std::string digits(16, '0');
  for (int n = 15; n >= 0; --n, value >>= 4)
    digits[static_cast<std::size_t>(n)] = "0123456789abcdef"[value & 15];
  return digits;
}

}  // namespace bozzetto
