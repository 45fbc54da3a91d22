#include "io/text_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "bozzetto/base/error.hpp"

namespace bozzetto {
namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// std::from_chars knows no leading plus.
std::string_view withoutPlus(std::string_view word) {
  const bool plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
  return plus ? word.substr(1) : word;
}

// Of a number out of range: too small rather than too large?
bool isTiny(std::string_view digits) {
  const auto exponent = digits.find_first_of("eE");
  if (exponent != std::string_view::npos) return digits.substr(exponent + 1).starts_with('-');
  return digits.find_first_of("123456789") > digits.find('.');
}

}  // namespace

std::string shownText(std::string_view found) {
  if (found.empty()) return "the end";
  std::string text = "'";
  for (const char c : found.substr(0, 32)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (found.size() > 32 ? "…'" : "'");
}

bool equalsIgnoringCase(std::string_view word, std::string_view lowerCase) {
  return std::equal(word.begin(), word.end(), lowerCase.begin(), lowerCase.end(),
                    [](char a, char b) { return lower(a) == b; });
}

TextReader::TextReader(std::span<const std::byte> bytes, std::string_view name, char comment)
    : text_(reinterpret_cast<const char*>(bytes.data()), bytes.size()),
      name_(name),
      comment_(comment) {}

void TextReader::skipBlanks() {
  while (!atEnd() && isBlank(text_[position_])) ++position_;
  if (atEnd() || comment_ == '\0' || text_[position_] != comment_) return;
  position_ = std::min(text_.find('\n', position_), text_.size());
}

void TextReader::skipLineEnd() {
  if (atEnd()) return;
  ++position_;
  ++line_;
}

std::string_view TextReader::wordOfLine() {
  skipBlanks();
  const std::size_t first = position_;
  while (!atEnd()) {
    const char c = text_[position_];
    if (isBlank(c) || c == '\n' || (comment_ != '\0' && c == comment_)) break;
    ++position_;
  }
  return text_.substr(first, position_ - first);
}

std::string_view TextReader::word() {
  skipBlanks();
  while (!atEnd() && text_[position_] == '\n') {
    skipLineEnd();
    skipBlanks();
  }
  return wordOfLine();
}

std::string_view TextReader::restOfLine() {
  const std::size_t first = position_;
  position_ = std::min(text_.find('\n', position_), text_.size());
  std::string_view rest = text_.substr(first, position_ - first);
  while (!rest.empty() && isBlank(rest.back())) rest.remove_suffix(1);
  skipLineEnd();
  return rest;
}

double TextReader::toNumber(std::string_view text) const {
  const auto digits = withoutPlus(text);
  double value = 0;
  const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (digits.empty() || end != digits.data() + digits.size()) fail(text, "a number");
  // Underflow is a zero for a sculptor; overflow and nan are nothing.
  if (fault == std::errc::result_out_of_range && isTiny(digits)) return 0;
  if (fault != std::errc{} || !std::isfinite(value)) fail(text, "a finite number");
  return value;
}

std::int64_t TextReader::toInteger(std::string_view text, std::int64_t low,
                                   std::int64_t high) const {
  const auto digits = withoutPlus(text);
  std::int64_t value = 0;
  const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  const bool whole = !digits.empty() && end == digits.data() + digits.size();
  if (!whole || fault != std::errc{} || value < low || value > high) {
    fail(text, "an integer from " + std::to_string(low) + " to " + std::to_string(high));
  }
  return value;
}

double TextReader::number() { return toNumber(word()); }

std::int64_t TextReader::integer(std::int64_t low, std::int64_t high) {
  return toInteger(word(), low, high);
}

double TextReader::fraction() const {
  return text_.empty() ? 1 : static_cast<double>(position_) / static_cast<double>(text_.size());
}

void TextReader::fail(std::string_view found, std::string_view expected) const {
  throw Error(std::string(name_) + ": line " + std::to_string(line_) + ": found " +
              shownText(found) + ", expected " + std::string(expected));
}

}  // namespace bozzetto
