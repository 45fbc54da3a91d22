// Texts for and from people.
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace bozzetto {

/// The code point that begins at `at`, which moves on; nothing, and `at` stays, where there is none
/// of UTF-8, or a control character.
std::optional<char32_t> nextCharacter(std::string_view text, std::size_t& at);

/// True for UTF-8 in one line, without control characters.
bool isOneLine(std::string_view text);

/// With small letters in place of A … Z; all else stays.
std::string lower(std::string_view text);

/// Six digits, however large or small the number is: "0.25", "1e+300".
std::string numberText(double number);

}  // namespace bozzetto
