#include "bozzetto/base/text.hpp"

#include <cctype>
#include <cstdio>

namespace bozzetto {

std::optional<char32_t> nextCharacter(std::string_view text, std::size_t& at) {
  const auto byte = [&](std::size_t n) -> unsigned {
    return n < text.size() ? static_cast<unsigned char>(text[n]) : 0;
  };
  const unsigned lead = byte(at);
  const std::size_t more = lead < 0x80 ? 0 : lead >> 5 == 6 ? 1 : lead >> 4 == 14 ? 2 : 3;
  bool sound = lead < 0x80 || (lead >= 0xc2 && lead < 0xf5);
  char32_t code = more == 0 ? lead : lead & (0x3fU >> more);
  for (std::size_t n = 1; n <= more; ++n) {
    sound = sound && byte(at + n) >> 6 == 2;
    code = code << 6 | (byte(at + n) & 0x3f);
  }
  constexpr char32_t kLeast[4] = {0x20, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xd800 && code < 0xe000;
  if (!sound || code < kLeast[more] || code == 0x7f || surrogate || code > 0x10ffff)
    return std::nullopt;
  at += more + 1;
  return code;
}

bool isOneLine(std::string_view text) {
  for (std::size_t at = 0; at < text.size();)
    if (!nextCharacter(text, at)) return false;
  return true;
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

std::string numberText(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", number);
  return text;
}

}  // namespace bozzetto
