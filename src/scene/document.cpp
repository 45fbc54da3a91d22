#include "bozzetto/scene/document.hpp"

#include <random>

namespace bozzetto {

SceneIdentity SceneIdentity::random() {
  std::random_device source;
  SceneIdentity identity;
  for (std::uint8_t& byte : identity.bytes) byte = static_cast<std::uint8_t>(source());
  return identity;
}

std::string SceneIdentity::text() const {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string digits;
  for (const std::uint8_t byte : bytes) {
    digits += kDigits[byte >> 4];
    digits += kDigits[byte & 15];
  }
  return digits;
}

}  // namespace bozzetto
