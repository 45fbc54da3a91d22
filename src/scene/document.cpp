#include "bozzetto/scene/document.hpp"

#include <sys/random.h>

#include <cerrno>
#include <random>

namespace bozzetto {

SceneIdentity SceneIdentity::random() {
  SceneIdentity identity;
  std::size_t done = 0;
  while (done < identity.bytes.size()) {
    const ssize_t got = ::getrandom(&identity.bytes[done], identity.bytes.size() - done, 0);
    if (got < 0 && errno != EINTR) break;
    if (got > 0) done += static_cast<std::size_t>(got);
  }
  std::random_device fallback;
  for (; done < identity.bytes.size(); ++done) {
    identity.bytes[done] = static_cast<std::uint8_t>(fallback());
  }
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
