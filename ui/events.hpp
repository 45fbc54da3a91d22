// What happens to the window, in order, whoever tells: GLFW, a script, a test.
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <variant>
#include <vector>

#include "ui/keys.hpp"

namespace bozzetto::ui {

enum class Button { left, right, middle };

struct PointerMoved {
  glm::dvec2 at{0};     ///< pixels from the window's top left corner
  double pressure = 1;  ///< 0…1; 1 for a mouse
};

struct ButtonChanged {
  Button button = Button::left;
  bool down = false;
};

struct WheelTurned {
  glm::dvec2 by{0};  ///< notches; +y away from the hand
};

struct KeyChanged {
  KeyCode key = KeyCode::none;
  bool down = false;
  bool repeated = false;
};

struct TextTyped {
  unsigned codepoint = 0;
};

struct FilesDropped {
  std::vector<std::string> paths;
};

/// Keys held while the window loses the keyboard are let go.
struct FocusChanged {
  bool focused = false;
};

struct CloseAsked {};

/// The window's pixels were lost, or its size is another.
struct RedrawAsked {};

/// A six-degree device: pushes and turns since the last one, −1…1 at full deflection, in the
/// picture's frame (x right, y up, z towards the viewer).
struct PuckMoved {
  glm::dvec3 push{0}, turn{0};
  double seconds = 0;  ///< for how long it was held so
};

struct PuckButton {
  int number = 0;
  bool down = false;
};

using InputEvent =
    std::variant<PointerMoved, ButtonChanged, WheelTurned, KeyChanged, TextTyped, FilesDropped,
                 FocusChanged, CloseAsked, RedrawAsked, PuckMoved, PuckButton>;

}  // namespace bozzetto::ui
