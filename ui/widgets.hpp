// The few controls all panels are made of.
#pragma once
#include <imgui.h>

#include <glm/gtc/quaternion.hpp>
#include <string>

#include "ui/keymap.hpp"
#include "ui/theme.hpp"

namespace bozzetto::ui {

/// A slider's numbers. `shown` is what stands on the right; typed numbers are × `typed`.
struct Slide {
  double low = 0, high = 1;
  const char* unit = "";
  double typed = 1;  ///< 100 for per cent
  int digits = 0;
  bool logarithmic = false;
  bool pen = false;  ///< pressure drives it
};

/// A place that can be clicked, drawn by whoever asks. At least a pixel wide and high: ImGui ends
/// the program over one that is not, and a low window leaves nothing for some.
bool hotArea(const char* id, ImVec2 size);

/// Label left, value right, a track below; Ctrl+click types a number. True while it changes.
bool slider(const char* label, double& value, const Slide& slide, const char* tip);

/// A rotation as angles about x, y and z; the middle one is a quarter turn at most. True while it
/// changes.
bool turnSliders(glm::dquat& rotation, const char* tip);

/// True when it was switched.
bool toggle(const char* label, bool& on, const char* tip);

/// A title that opens and closes what follows. True when open.
bool section(const char* title, bool openAtFirst = true);

/// One of a choice's names; where `whyNot` says something, it cannot be chosen.
struct Choice {
  const char* name;
  const char* whyNot = "";
  Choice(const char* text, const char* reason = "") : name(text), whyNot(reason) {}
};
/// A label and names under it, in as few rows as hold them, one of them chosen. A label that
/// begins with ## is not shown. True when another was chosen.
bool choice(const char* label, int& chosen, std::initializer_list<Choice> names, const char* tip);

/// A button across the panel's width. `accent` for the one that matters.
enum class ButtonKind { plain, accent };
bool button(const char* label, ImVec2 size, ButtonKind kind = ButtonKind::plain,
            const char* tip = "");

/// A square of colour; a ring around the chosen one. True when clicked.
bool swatch(const char* id, Colour colour, float side, bool chosen);

/// Label left, value right.
void factLine(const char* label, const std::string& value, const char* tip = "");

/// For the item before. With the command's key where it has one.
void tooltip(const std::string& text);
void tooltip(const Keymap& keymap, Command command);

/// "396 260".
std::string grouped(long long number);
/// "31 MB".
std::string byteText(double bytes);

/// A dialog in the middle of the window, over everything; a height of 0 fits what is in it. Where
/// `open` is given it has a cross that clears it. False when it is not there; else EndPopup.
bool beginModal(const char* title, ImVec2 size, bool* open = nullptr);

/// Windows that stand where they are put.
inline constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                           ImGuiWindowFlags_NoSavedSettings |
                                           ImGuiWindowFlags_NoBringToFrontOnFocus;

}  // namespace bozzetto::ui
