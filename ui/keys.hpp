// Keys and chords by name, free of any window library.
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace bozzetto::ui {

/// Numbers are GLFW's, so that its back end casts; letters and digits are their ASCII capitals.
enum class KeyCode : int {
  none = 0,
  space = 32,
  minus = 45,
  period = 46,
  zero = 48,
  equal = 61,
  a = 65,
  leftBracket = 91,
  rightBracket = 93,
  escape = 256,
  enter,
  tab,
  backspace,
  insert,
  del,
  right,
  left,
  down,
  up,
  pageUp,
  pageDown,
  home,
  end,
  f1 = 290,
  f12 = 301,
  numpad0 = 320,
  numpad9 = 329,
  numpadDecimal,
  numpadDivide,
  numpadMultiply,
  numpadSubtract,
  numpadAdd,
  numpadEnter,
  leftShift = 340,
  leftControl,
  leftAlt,
  rightShift = 344,
  rightControl,
  rightAlt,
  last = 348
};

constexpr KeyCode letter(char capital) { return static_cast<KeyCode>(capital); }
constexpr KeyCode numpad(int digit) { return static_cast<KeyCode>(320 + digit); }
constexpr KeyCode function(int number) { return static_cast<KeyCode>(289 + number); }

struct Modifiers {
  bool ctrl = false, shift = false, alt = false;
  friend constexpr bool operator==(Modifiers, Modifiers) = default;
  constexpr bool none() const { return !ctrl && !shift && !alt; }
};

/// A key with the modifiers that are held.
struct Chord {
  KeyCode key = KeyCode::none;
  Modifiers with;
  friend constexpr bool operator==(const Chord&, const Chord&) = default;
};

bool isModifier(KeyCode key);

/// "Ctrl+Shift+Z", "Num 7", "["; empty for no key.
std::string toText(const Chord& chord);
/// The chord of such a text, or nothing.
std::optional<Chord> chordNamed(std::string_view text);

}  // namespace bozzetto::ui
