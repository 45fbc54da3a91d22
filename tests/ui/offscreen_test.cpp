// The whole window drawn without a display: what is seen, and what it costs.
#include <cstdlib>
#include <fstream>

#include "ui/offscreen_window.hpp"

namespace bozzetto::ui {
namespace {

// A ball of a quarter of the work; the window's own picture is looked at once, in full.
class Drawn : public Offscreen {
 protected:
  Drawn() : Offscreen(24, {960, 600}) {}
};

int distance(const Image::Pixel& a, Colour b) {
  return std::abs(a[0] - b.r) + std::abs(a[1] - b.g) + std::abs(a[2] - b.b);
}

TEST_F(Offscreen, panelsHaveTheirColoursAndClayIsInTheMiddle) {
  const Image image = picture("opened");
  EXPECT_LE(distance(image.at(640, 3), parseColour("#18191c")), 6);    // top bar
  EXPECT_LE(distance(image.at(4, 400), parseColour("#1e2023")), 6);    // tool column
  EXPECT_LE(distance(image.at(998, 300), parseColour("#1e2023")), 6);  // properties
  EXPECT_LE(distance(image.at(14, 58), parseColour("#e0764a")), 60);   // the tool in hand
  const Image::Pixel& clay = image.at(int(middle().x), int(middle().y));
  EXPECT_GT(clay[0], clay[2] + 30);  // terracotta
  const Image::Pixel& air = image.at(int(middle().x), 60);
  EXPECT_LT(std::abs(air[0] - air[2]), 20);  // the cool studio
}

TEST_F(Drawn, nothingIsMagenta) {
  for (const Dialog dialog : {Dialog::none, Dialog::open, Dialog::help, Dialog::unsaved,
                              Dialog::recovered, Dialog::leftBehind}) {
    atelier_.dialog = dialog;
    settle();
    const Image image = picture("dialog_" + std::to_string(int(dialog)));
    int magenta = 0;
    for (const Image::Pixel& pixel : image.pixels)
      magenta += pixel[0] > 240 && pixel[2] > 240 && pixel[1] < 20;
    EXPECT_EQ(magenta, 0) << int(dialog);
  }
}

TEST_F(Drawn, movingThePointerKeepsTheClaysPicture) {
  moveTo(middle());
  settle();
  moveTo(middle() + glm::dvec2(10, 5));
  frame();
  EXPECT_EQ(interface_.figures.viewport.clay, FrameReport::Clay::kept);
  EXPECT_EQ(interface_.figures.viewport.uploadedBytes, 0);
  picture("hover");
}

TEST_F(Drawn, aStrokeIsSeen) {
  moveTo(middle());
  settle();
  const Image before = picture("stroke_before");
  interface_.post(ButtonChanged{Button::left, true});
  for (int n = 0; n < 30; ++n) moveTo(middle() + glm::dvec2(4 * n, -2 * n));
  interface_.post(ButtonChanged{Button::left, false});
  moveTo({200, 560});
  settle();
  const Image after = picture("stroke_after");
  long changed = 0;
  for (int y = 100; y < 500; ++y)
    for (int x = 100; x < 650; ++x)
      changed += std::abs(after.at(x, y)[0] - before.at(x, y)[0]) > 12;
  EXPECT_GT(changed, 1500);
}

TEST_F(Drawn, sizeAndScaleChangeTogether) {
  resize({1280, 800});
  interface_.setScale(1.2f);
  EXPECT_NO_THROW(settle());
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

// Panels of the frame in which a document goes still show the pictures of its steps.
TEST_F(Drawn, picturesGoWithTheirDocument) {
  rest();
  ASSERT_FALSE(interface_.pictures.steps.empty());
  atelier_.run(Command::newBlock);
  EXPECT_NO_THROW(rest());
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

// Nobody saw these happen.
TEST_F(Drawn, replayedStepsHavePictures) {
  const testing::Folder folder;
  const std::filesystem::path path = folder / "three.jsonl";
  std::ofstream(path) << R"({"bozzetto":"recording","version":1}
{"op":"fill","shape":"ellipsoid","radii":[9,9,9]}
{"op":"fill","shape":"box","center":[9,0,0],"radii":[5,5,5]}
{"op":"fill","shape":"ellipsoid","center":[0,9,0],"radii":[5,5,5]}
)";
  atelier_.thumbnail = [this] { return canvas_.thumbnail(); };
  atelier_.worker().post([](ClayDesk& desk) { desk.startNew(NewClay::empty); });
  settle();
  atelier_.replay(path);
  rest();
  for (StepNumber step = 1; step <= 3; ++step)
    EXPECT_TRUE(interface_.pictures.steps.contains(step)) << step;
  atelier_.worker().post([](ClayDesk& desk) {
    for (StepNumber step = 1; step <= 3; ++step)
      EXPECT_FALSE(desk.sculptor().history().thumbnail(step).empty()) << step;
  });
  settle();
}

}  // namespace
}  // namespace bozzetto::ui
