// Names as people type them.
#pragma once
#include <string>
#include <string_view>

namespace bozzetto {

/// With small letters in place of A … Z; all else stays.
std::string lower(std::string_view text);

}  // namespace bozzetto
