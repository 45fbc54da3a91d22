// Shortest decimal text that reads back as the same number, whatever the locale.
#pragma once
#include <charconv>
#include <string>

namespace bozzetto {

template <class Number>
void appendNumber(std::string& text, Number value) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof(digits), value).ptr;
  text.append(digits, end);
}

/// The numbers with a blank before each.
template <class Vector>
void appendVector(std::string& text, const Vector& v) {
  for (int axis = 0; axis < 3; ++axis) {
    text += ' ';
    appendNumber(text, v[axis]);
  }
}

}  // namespace bozzetto
