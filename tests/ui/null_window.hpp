// A window that nobody draws: events in, clay out. Its documents without a name live in a folder of
// the test's own.
#pragma once
#include <gtest/gtest.h>

#include <cstdlib>

#include "support/folder.hpp"
#include "ui/interface.hpp"

namespace bozzetto::ui {

/// Where work without a name goes while this lives.
class StateFolder {
 public:
  StateFolder() { ::setenv("XDG_STATE_HOME", folder_.path().c_str(), 1); }

 private:
  testing::Folder folder_;
};

class NullWindow {
 public:
  static constexpr double kRadius =
      24;  // of new balls: half of what people get, a quarter the work
  explicit NullWindow(const std::filesystem::path& scene = {})
      : atelier_(Atelier::Options{scene, {}, [] {}, kRadius}), interface_(atelier_) {
    settle();
  }

  void frame() {
    now_ += 1 / 60.0;
    Publication fresh = interface_.frame(size_, now_);
    uploaded_ += fresh.uploadBytes();
  }
  // All events read, all clay done, all of it taken.
  void settle() {
    do {
      frame();
    } while (interface_.hasEvents());
    atelier_.worker().waitUntilSettled();
    frame();
    while (atelier_.job() || atelier_.hasNews()) {
      atelier_.worker().waitUntilSettled();
      frame();
    }
    frame();
  }
  void post(InputEvent event) { interface_.post(std::move(event)); }
  void moveTo(glm::dvec2 at) { post(PointerMoved{at, 1}); }
  void tap(KeyCode key) {
    post(KeyChanged{key, true, false});
    post(KeyChanged{key, false, false});
  }
  void tapCtrl(KeyCode key) {
    post(KeyChanged{KeyCode::leftControl, true, false});
    tap(key);
    post(KeyChanged{KeyCode::leftControl, false, false});
  }
  void drag(glm::dvec2 from, glm::dvec2 to, Button button = Button::left) {
    moveTo(from);
    post(ButtonChanged{button, true});
    for (int n = 1; n <= 10; ++n) moveTo(from + (to - from) * (n / 10.0));
    post(ButtonChanged{button, false});
    settle();
  }
  glm::dvec2 middle() const { return interface_.layout().viewport.centre(); }
  double mass() { return atelier_.status().mass; }
  std::uint64_t hash() {
    std::uint64_t result = 0;
    atelier_.worker().post([&](ClayDesk& desk) { result = fieldHash(desk.sculptor().field()); });
    settle();
    return result;
  }
  // Of what a recording makes of nothing.
  std::uint64_t replayed(const std::filesystem::path& path) {
    atelier_.worker().post([](ClayDesk& desk) { desk.startNew(NewClay::empty); });
    atelier_.replay(path);
    settle();
    return hash();
  }
  // All that was done so far gives the same clay again.
  void expectReplays() {
    const testing::Folder folder;
    const std::filesystem::path path = folder / "by hand.jsonl";
    const std::uint64_t before = hash();
    atelier_.saveRecording(path);
    settle();
    EXPECT_EQ(replayed(path), before);
  }
  void click(glm::dvec2 at, Button button = Button::left) {
    moveTo(at);
    settle();
    post(ButtonChanged{button, true});
    settle();
    post(ButtonChanged{button, false});
    settle();
  }
  void type(const std::string& text) {
    for (const char c : text) post(TextTyped{unsigned(c)});
    settle();
  }
  std::size_t steps() { return atelier_.status().done; }

  glm::dvec2 size_{1280, 800};
  Atelier atelier_;
  Interface interface_;
  double now_ = 0;
  std::size_t uploaded_ = 0;
};

/// One to a test.
class Null : public ::testing::Test, protected StateFolder, protected NullWindow {};

}  // namespace bozzetto::ui
