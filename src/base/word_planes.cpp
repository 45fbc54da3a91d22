#include "bozzetto/base/word_planes.hpp"

namespace bozzetto {

void putPlanes(ByteWriter& out, const std::vector<std::uint32_t>& words) {
  Bytes plane(words.size());
  for (const int shift : {0, 8, 16, 24}) {
    for (std::size_t n = 0; n < words.size(); ++n) {
      plane[n] = static_cast<std::byte>(words[n] >> shift);
    }
    out.put(std::span<const std::byte>(plane));
  }
}

std::vector<std::uint32_t> getPlanes(ByteReader& in, std::size_t count) {
  const auto planes = in.take(4 * count);
  std::vector<std::uint32_t> words(count);
  for (std::size_t byte = 0; byte < 4; ++byte) {
    const auto plane = planes.subspan(byte * count, count);
    for (std::size_t n = 0; n < count; ++n) {
      words[n] |= std::to_integer<std::uint32_t>(plane[n]) << (8 * byte);
    }
  }
  return words;
}

}  // namespace bozzetto
