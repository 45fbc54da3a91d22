// Colours are sRGB, 8 bits a channel, as people pick them. Blending happens in these numbers.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace bozzetto {

struct Colour {
  std::uint8_t r = 0xac, g = 0x70, b = 0x52;  // terracotta
  friend constexpr bool operator==(const Colour&, const Colour&) = default;
};

/// "#rrggbb" → colour. Throws Error for anything else.
Colour parseColour(std::string_view text);

/// "#rrggbb", lower case.
std::string toText(Colour colour);

}  // namespace bozzetto
