#include "bozzetto/base/colour.hpp"

#include <charconv>

#include "bozzetto/base/error.hpp"
#include "bozzetto/base/hash.hpp"

namespace bozzetto {

Colour parseColour(std::string_view text) {
  unsigned rgb = 0;
  const bool shaped = text.size() == 7 && text[0] == '#';
  const char* end = text.data() + text.size();
  if (!shaped || std::from_chars(text.data() + 1, end, rgb, 16).ptr != end) {
    throw Error("colour '" + std::string(text.substr(0, 40)) + "' is not of the form #rrggbb");
  }
  return {static_cast<std::uint8_t>(rgb >> 16), static_cast<std::uint8_t>(rgb >> 8),
          static_cast<std::uint8_t>(rgb)};
}

std::string toText(Colour colour) {
  return "#" + hexDigits(std::uint64_t{colour.r} << 16 | std::uint64_t{colour.g} << 8 | colour.b)
                   .substr(10);
}

}  // namespace bozzetto
