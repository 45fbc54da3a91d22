// Words and numbers from text files that strangers made, with the line for error messages.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace bozzetto {

/// A cursor over text it does not own. Words are separated by blanks; nothing is copied.
class TextReader {
 public:
  /// With a `comment` character, the rest of a line from there on is blank.
  TextReader(std::span<const std::byte> bytes, std::string_view name, char comment = '\0');

  /// The next word, over line ends; empty at the end of the text.
  std::string_view word();
  /// The next word of this line; empty at its end.
  std::string_view wordOfLine();
  /// What is left of this line as it stands, without its end; moves to the next line.
  std::string_view restOfLine();

  /// The next word as a finite number, over line ends.
  double number();
  /// The next word as an integer within [low, high].
  std::int64_t integer(std::int64_t low, std::int64_t high);

  double toNumber(std::string_view word) const;
  std::int64_t toInteger(std::string_view word, std::int64_t low, std::int64_t high) const;

  bool atEnd() const { return position_ >= text_.size(); }
  std::size_t position() const { return position_; }
  std::size_t remaining() const { return text_.size() - position_; }
  double fraction() const;

  /// Throws Error: name, line, what was found, what was expected.
  [[noreturn]] void fail(std::string_view found, std::string_view expected) const;

 private:
  void skipBlanks();
  void skipLineEnd();

  std::string_view text_;
  std::string_view name_;
  std::size_t position_ = 0;
  std::size_t line_ = 1;
  char comment_;
};

/// A stranger's words, fit for a one-line message: short and printable.
std::string shownText(std::string_view found);

bool equalsIgnoringCase(std::string_view word, std::string_view lowerCase);

}  // namespace bozzetto
