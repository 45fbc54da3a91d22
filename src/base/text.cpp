#include "bozzetto/base/text.hpp"

#include <cctype>

namespace bozzetto {

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

}  // namespace bozzetto
