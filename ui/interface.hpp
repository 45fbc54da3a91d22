// The window's inside: events go in, an ImGui frame comes out. Works the same behind a real window,
// off-screen, and with nobody drawing at all.
#pragma once
#include <imgui.h>

#include <deque>

#include "ui/panels.hpp"

namespace bozzetto::ui {

class Interface {
 public:
  explicit Interface(Atelier& atelier);
  ~Interface();
  Interface(const Interface&) = delete;
  Interface& operator=(const Interface&) = delete;

  /// Of the interface, less where the window is too small for it; fonts are built anew before the
  /// next frame when it changes.
  void setScale(float scale);
  /// Makes the fonts' texture, before the first frame that is built with them.
  std::function<void()> fontsChanged;

  void post(InputEvent event) { events_.push_back(std::move(event)); }
  /// Events are left for the next frame: draw one more soon.
  bool hasEvents() const { return !events_.empty(); }

  /// Lays out and builds one frame of `size` pixels at `now` seconds: events, panels,
  /// ImGui::Render. What changed of the clay is returned for the renderer.
  Publication frame(glm::dvec2 size, double now);

  const Layout& layout() const { return layout_; }
  UiPictures pictures;
  FrameFigures figures;

 private:
  bool feedOne(const InputEvent& event);
  void feed();
  void feedPointer(const PointerMoved& event);
  bool feedButton(const ButtonChanged& event);
  bool feedKey(const KeyChanged& event);
  void rebind(const Chord& chord);
  void releaseAll();
  bool panelsHavePointer() const;
  bool panelsHaveKeys() const;
  void build();
  float fittingScale(glm::dvec2 size) const;

  Atelier* atelier_;
  ImGuiContext* context_;
  std::deque<InputEvent> events_;
  Layout layout_;
  float scale_ = 1, builtScale_ = 0;
  double last_ = 0;
  // What ImGui has been told in this frame: it sees one change of a button a frame.
  bool movedNow_ = false, buttonNow_[3] = {};
  std::vector<KeyCode> keysNow_;
  Modifiers held_;
  bool onClay_[3] = {};  // buttons that went down in the viewport
};

}  // namespace bozzetto::ui
