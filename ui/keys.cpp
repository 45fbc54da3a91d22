#include "ui/keys.hpp"

#include <array>
#include <utility>

namespace bozzetto::ui {
namespace {

using Name = std::pair<KeyCode, std::string_view>;

constexpr std::array<Name, 26> kNames{{
    {KeyCode::space, "Space"},
    {KeyCode::minus, "-"},
    {KeyCode::period, "."},
    {KeyCode::equal, "="},
    {KeyCode::leftBracket, "["},
    {KeyCode::rightBracket, "]"},
    {KeyCode::escape, "Esc"},
    {KeyCode::enter, "Enter"},
    {KeyCode::tab, "Tab"},
    {KeyCode::backspace, "Backspace"},
    {KeyCode::insert, "Insert"},
    {KeyCode::del, "Delete"},
    {KeyCode::right, "Right"},
    {KeyCode::left, "Left"},
    {KeyCode::down, "Down"},
    {KeyCode::up, "Up"},
    {KeyCode::pageUp, "Page up"},
    {KeyCode::pageDown, "Page down"},
    {KeyCode::home, "Home"},
    {KeyCode::end, "End"},
    {KeyCode::numpadDecimal, "Num ."},
    {KeyCode::numpadDivide, "Num /"},
    {KeyCode::numpadMultiply, "Num *"},
    {KeyCode::numpadSubtract, "Num -"},
    {KeyCode::numpadAdd, "Num +"},
    {KeyCode::numpadEnter, "Num Enter"},
}};

std::string nameOf(KeyCode key) {
  const int code = static_cast<int>(key);
  for (const Name& name : kNames)
    if (name.first == key) return std::string(name.second);
  if ((code >= 'A' && code <= 'Z') || (code >= '0' && code <= '9')) {
    return std::string(1, static_cast<char>(code));
  }
  if (key >= KeyCode::f1 && key <= KeyCode::f12) return "F" + std::to_string(code - 289);
  if (key >= KeyCode::numpad0 && key <= KeyCode::numpad9) {
    return "Num " + std::to_string(code - 320);
  }
  return "";
}

}  // namespace

bool isModifier(KeyCode key) { return key >= KeyCode::leftShift && key <= KeyCode::last; }

std::string toText(const Chord& chord) {
  const std::string key = nameOf(chord.key);
  if (key.empty()) return "";
  std::string text;
  if (chord.with.ctrl) text += "Ctrl+";
  if (chord.with.alt) text += "Alt+";
  if (chord.with.shift) text += "Shift+";
  return text + key;
}

std::optional<Chord> chordNamed(std::string_view text) {
  Chord chord;
  const auto take = [&](std::string_view prefix, bool& held) {
    if (text.starts_with(prefix)) {
      held = true;
      text.remove_prefix(prefix.size());
    }
  };
  take("Ctrl+", chord.with.ctrl);
  take("Alt+", chord.with.alt);
  take("Shift+", chord.with.shift);
  for (int code = 1; code <= static_cast<int>(KeyCode::last); ++code) {
    chord.key = static_cast<KeyCode>(code);
    if (nameOf(chord.key) == text && !text.empty()) return chord;
  }
  return std::nullopt;
}

}  // namespace bozzetto::ui
