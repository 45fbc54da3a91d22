// Whatever is pressed, dragged, dropped and resized, the window stands: no assertion of ImGui, no
// uncaught error, no clay that fails its laws. Always the same inputs, or those of BOZZETTO_SEED.
#include <cstdlib>
#include <random>

#include "bozzetto/field/field.hpp"
#include "null_window.hpp"
#include "ui/commands.hpp"

namespace bozzetto::ui {
namespace {

class RandomHand {
 public:
  RandomHand(NullWindow& window, unsigned seed) : window_(window), random_(seed) {}

  void act() {
    switch (below(12)) {
      case 0:
      case 1:
      case 2:
        return press(commandTable()[below(commandTable().size())]);
      case 3:
        return press(Chord{KeyCode(below(int(KeyCode::last))), modifiers()});
      case 4:
        return window_.post(WheelTurned{{between(-2, 2), between(-2, 2)}});
      case 5:
        return window_.post(TextTyped{unsigned(below(0x300))});
      case 6:
        return resize();
      case 7:
        return puck();
      default:
        return drag();
    }
  }

 private:
  std::size_t below(std::size_t end) { return random_() % end; }
  double between(double low, double high) {
    return low + (high - low) * double(random_()) / 0xFFFFFFFFu;
  }
  bool oneIn(std::size_t n) { return below(n) == 0; }
  Modifiers modifiers() { return {oneIn(4), oneIn(4), oneIn(6)}; }
  glm::dvec2 anywhere() {
    return {between(-20, window_.size_.x + 20), between(-20, window_.size_.y + 20)};
  }

  void press(const CommandRow& row) {
    if (row.command == Command::quit) return;
    for (const Chord& chord : chordsOf(row.blender)) press(chord);
  }
  void press(const Chord& chord) {
    if (isModifier(chord.key)) return;
    hold(chord.with, true);
    window_.tap(chord.key);
    hold(chord.with, false);
  }
  void hold(Modifiers with, bool down) {
    if (with.ctrl) window_.post(KeyChanged{KeyCode::leftControl, down, false});
    if (with.shift) window_.post(KeyChanged{KeyCode::leftShift, down, false});
    if (with.alt) window_.post(KeyChanged{KeyCode::leftAlt, down, false});
  }
  void drag() {
    const auto button = Button(below(3));
    const Modifiers with = modifiers();
    window_.moveTo(anywhere());
    hold(with, true);
    window_.post(ButtonChanged{button, true});
    for (std::size_t n = below(4); n-- > 0;) window_.moveTo(anywhere());
    window_.post(ButtonChanged{button, false});
    hold(with, false);
  }
  // From nothing to more than any screen, mostly what people have.
  void resize() {
    window_.size_ = oneIn(4) ? glm::dvec2{below(5000), below(3000)} : glm::dvec2{1280, 800};
    window_.post(RedrawAsked{});
  }
  void puck() {
    if (oneIn(4)) return window_.post(FocusChanged{oneIn(2)});
    const glm::dvec3 push{between(-1, 1), between(-1, 1), between(-1, 1)};
    window_.post(PuckMoved{push, push, .01});
  }

  NullWindow& window_;
  std::mt19937 random_;
};

// Of tools, world units: larger ones at a view from far away make gigabytes.
constexpr double kLargestTool = 12;

struct RandomInput : Null {
  testing::Folder folder_;

  // Whoever presses keys at random would stay in a dialog for long, or look from far away, where
  // the smallest stroke is miles long.
  void comeBack() {
    atelier_.dialog = Dialog::none;
    atelier_.run(Command::frameAll);
  }

  void standsUnder(unsigned seed, int actions) {
    SCOPED_TRACE("BOZZETTO_SEED=" + std::to_string(seed));
    atelier_.settings.folder = folder_.path().string();
    RandomHand hand(*this, seed);
    for (int n = 0; n < actions; ++n) {
      hand.act();
      n % 16 == 0 ? settle() : frame();
      atelier_.sculpt.size = std::min(atelier_.sculpt.size, kLargestTool);
      if (n % 8 == 7) comeBack();
    }
    settle();
    std::optional<std::string> fault;
    atelier_.worker().post([&](ClayDesk& desk) { fault = validate(desk.sculptor().field()); });
    settle();
    EXPECT_FALSE(fault) << *fault;
  }
};

unsigned firstSeed() {
  const char* given = std::getenv("BOZZETTO_SEED");
  return given ? unsigned(std::atoi(given)) : 5;
}

TEST_F(RandomInput, LeavesTheWindowStanding) { standsUnder(firstSeed(), 100); }
TEST_F(RandomInput, SlowLeavesTheWindowStandingForLong) { standsUnder(firstSeed() + 1, 600); }

}  // namespace
}  // namespace bozzetto::ui
