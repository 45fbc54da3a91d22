// Texts for and from people.
#pragma once
#include <string>
#include <string_view>

namespace bozzetto {

/// With small letters in place of A … Z; all else stays.
std::string lower(std::string_view text);

/// Six digits, however large or small the number is: "0.25", "1e+300".
std::string numberText(double number);

}  // namespace bozzetto
