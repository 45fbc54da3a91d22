// The interface as it was when somebody looked at it last: panels, modes and dialogs, drawn without
// a display. BOZZETTO_UPDATE_GOLDEN=1 writes the pictures anew, to be looked at again; full size
// they are under window/ in the build folder.
//
// Tolerance, on pictures of half or a quarter of the size: 1.5 of 255 on average, 28 in the worst
// block of 8 × 8. Another version of FreeType or Mesa stays below; a control that is missing or
// stands elsewhere does not.
#include <imgui_internal.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "bozzetto/base/file.hpp"
#include "ui/offscreen_window.hpp"

namespace bozzetto::ui {
namespace {

namespace fs = std::filesystem;

constexpr double kMeanTolerance = 1.5, kBlockTolerance = 28;

Image cropped(const Image& image, const Rect& at) {
  Image part{int(at.width()), int(at.height())};
  for (int y = 0; y < part.height; ++y)
    for (int x = 0; x < part.width; ++x)
      part.at(x, y) = image.at(int(at.low.x) + x, int(at.low.y) + y);
  return part;
}

// Means of squares of pixels.
Image shrunk(const Image& image, int by) {
  Image small{image.width / by, image.height / by};
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      int sum[3] = {};
      for (int n = 0; n < by * by; ++n)
        for (int c = 0; c < 3; ++c) sum[c] += image.at(x * by + n % by, y * by + n / by)[c];
      for (int c = 0; c < 3; ++c) small.at(x, y)[c] = std::uint8_t(sum[c] / (by * by));
      small.at(x, y)[3] = 255;
    }
  }
  return small;
}

double difference(const Image& a, const Image& b, const Rect& in) {
  double sum = 0;
  for (int y = int(in.low.y); y < int(in.high.y); ++y)
    for (int x = int(in.low.x); x < int(in.high.x); ++x)
      for (int c = 0; c < 3; ++c) sum += std::abs(a.at(x, y)[c] - b.at(x, y)[c]);
  return sum / (3 * in.width() * in.height());
}

double worstBlock(const Image& a, const Image& b) {
  double worst = 0;
  for (int y = 0; y + 8 <= a.height; y += 8)
    for (int x = 0; x + 8 <= a.width; x += 8)
      worst = std::max(worst, difference(a, b, {{x, y}, {x + 8, y + 8}}));
  return worst;
}

class Panels : public Offscreen {
 protected:
  enum class What { window, properties, viewport, middle, comparison };

  // One quality, however fast the machine is.
  explicit Panels(double radius = 48, glm::dvec2 size = {1280, 800}) : Offscreen(radius, size) {
    atelier_.options.quality = Quality::light;
  }

  // Something to look at: a stroke across the ball, one into it.
  void carve() {
    for (const Command tool : {Command::toolAdd, Command::toolErase}) {
      atelier_.run(tool);
      const glm::dvec2 from = middle() + glm::dvec2(-90, tool == Command::toolAdd ? -60 : 70);
      moveTo(from);
      settle();
      interface_.post(ButtonChanged{Button::left, true});
      for (int step = 1; step <= 8; ++step) moveTo(from + glm::dvec2(16 * step, 5 * step));
      interface_.post(ButtonChanged{Button::left, false});
      settle();
    }
    atelier_.run(Command::toolAdd);
    moveTo({2, 2});
    settle();
  }
  // Panels must not show how fast this machine is.
  void still() {
    settle();
    for (int n = 0; n < 2000 && !atelier_.status().isLit; ++n) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      frame();
    }
    settle();
    for (ShelfCard& card : atelier_.shelf.cards) card.picture.reset();  // come when there is time
    interface_.figures = {};
    interface_.figures.viewport.quality = Quality::light;
    atelier_.touch();
    frame();
  }
  Image seen(const Image& whole, What what) {
    const Layout& layout = interface_.layout();
    if (what == What::window) return shrunk(whole, whole.width / 320);
    if (what == What::properties) return shrunk(cropped(whole, layout.properties), 2);
    if (what == What::viewport) return shrunk(cropped(whole, layout.viewport), 3);
    if (what == What::middle) return cropped(whole, {middle() - 60., middle() + 60.});
    const glm::dvec2 corner = layout.viewport.high;  // below the steps, whose times are now
    return shrunk(cropped(whole, {corner - glm::dvec2(300, 290), corner}), 2);
  }
  void expectAsItWas(const std::string& name, What what) {
    still();
    const Image whole = picture(name);
    const Image now = seen(whole, what);
    const std::string path = std::string(BOZZETTO_SOURCE_DIR) + "/tests/golden/ui/" + name + ".png";
    if (std::getenv("BOZZETTO_UPDATE_GOLDEN") != nullptr) writePng(path, now);
    const Image then = readPng(path);
    ASSERT_EQ(now.width, then.width) << name;
    ASSERT_EQ(now.height, then.height) << name;
    EXPECT_LT(difference(now, then, {{0, 0}, {now.width, now.height}}), kMeanTolerance) << name;
    EXPECT_LT(worstBlock(now, then), kBlockTolerance) << name;
  }
  // Of the properties only these are open.
  void openSections(std::initializer_list<const char*> names) {
    ImGuiWindow* window = ImGui::FindWindowByName("properties");
    for (const char* each : kSections) window->StateStorage.SetBool(window->GetID(each), false);
    for (const char* name : names) window->StateStorage.SetBool(window->GetID(name), true);
    ImGui::SetScrollY(window, 0);
  }
  void expectSection(const char* section, const std::string& name) {
    openSections({section});
    expectAsItWas(name, What::properties);
  }

  static constexpr std::array kSections{"How clay gives way",
                                        "Look",
                                        "Colour",
                                        "Tool",
                                        "Placement",
                                        "Stroke",
                                        "Symmetry",
                                        "Lights",
                                        "View",
                                        "References",
                                        "Held clay",
                                        "Supports",
                                        "Mass",
                                        "Clay",
                                        "Performance",
                                        "Make",
                                        "Back to clay",
                                        "Show",
                                        "Physics",
                                        "Numbers"};
};

TEST_F(Panels, sections) {
  resize({900, 1400});
  expectSection("Look", "section_look");
  expectSection("Colour", "section_colour");
  expectSection("Tool", "section_tool");
  expectSection("Placement", "section_placement");
  expectSection("Stroke", "section_stroke");
  expectSection("Symmetry", "section_symmetry");
  expectSection("Lights", "section_lights");
  expectSection("View", "section_view");
  expectSection("Held clay", "section_held_clay");
  expectSection("Clay", "section_clay");
  openSections({"Performance"});
  still();
  picture("section_performance");  // its times are this machine's
}

TEST_F(Panels, sectionsOfTools) {
  resize({900, 1400});
  atelier_.run(Command::toolStamp);
  expectSection("", "section_stamp");
  atelier_.run(Command::toolPush);
  expectSection("How clay gives way", "section_moving");
  atelier_.run(Command::placeTable);
  settle();
  atelier_.chosenSupport = 0;
  expectSection("Supports", "section_supports");
  expectSection("Mass", "section_mass");
}

TEST_F(Panels, solidMode) {
  resize({900, 1400});
  atelier_.run(Command::solidMode);
  expectSection("Make", "section_solid_make");
  atelier_.run(Command::newEmpty);
  settle();
  atelier_.solid.cells = {2, 3, 2};
  atelier_.run(Command::solidBlock);
  expectSection("Show", "section_solid_show");
  expectSection("Physics", "section_solid_physics");
  expectSection("Numbers", "section_solid_numbers");
  expectSection("Back to clay", "section_solid_back");
  resize({1280, 800});
  openSections({"Show"});
  for (const SolidMap map : {SolidMap::stiffness, SolidMap::mass, SolidMap::strain}) {
    atelier_.solid.map = map;
    atelier_.tellSolid();
    expectAsItWas("solid_map_" + std::to_string(int(map)), What::window);
  }
}

TEST_F(Panels, theWindow) {
  expectAsItWas("start", What::window);
  atelier_.shelf.open = true;
  atelier_.listShelf();
  expectAsItWas("shelf", What::window);
  atelier_.shelf.open = false;
  moveTo(middle());
  settle();
  for (int n = 0; n < 3; ++n) {
    interface_.post(ButtonChanged{Button::left, true});
    for (int step = 0; step < 8; ++step)
      moveTo(middle() + glm::dvec2(60 * n - 90 + 6 * step, 20 * n - 40));
    interface_.post(ButtonChanged{Button::left, false});
    settle();
  }
  rest();
  expectAsItWas("strokes", What::window);
  atelier_.historyShown = true;
  still();
  picture("history");  // its times are now
  atelier_.historyShown = false;
  atelier_.paletteOpen = true;
  atelier_.palettePlace = middle();
  expectAsItWas("palette", What::window);
}

TEST_F(Panels, dialogs) {
  const testing::Folder temporary;
  // So deep that what differs between machines is not shown.
  const fs::path folder = temporary / "What somebody made in a year of long evenings" /
                          "Commissions, studies and sketches" / "Fauns and other friends";
  fs::create_directories(folder / "older");
  for (const char* name : {"faun.bzt", "hand study.bzt", "horns.bzt", "head.ply"}) {
    writeFile(folder / name, Bytes(123456));
  }
  atelier_.settings.folder = folder.string();
  for (const auto& [dialog, name] :
       std::initializer_list<std::pair<Dialog, const char*>>{{Dialog::help, "help"},
                                                             {Dialog::unsaved, "unsaved"},
                                                             {Dialog::open, "open"},
                                                             {Dialog::saveAs, "save_as"},
                                                             {Dialog::import, "import"},
                                                             {Dialog::exportMesh, "export"},
                                                             {Dialog::turntable, "turntable"}}) {
    atelier_.dialog = dialog;
    expectAsItWas(std::string("dialog_") + name, What::window);
    atelier_.dialog = Dialog::none;
    settle();
  }
  // These tell times.
  for (const auto& [dialog, name] : std::initializer_list<std::pair<Dialog, const char*>>{
           {Dialog::recovered, "recovered"}, {Dialog::leftBehind, "left_behind"}}) {
    atelier_.dialog = dialog;
    still();
    picture(std::string("dialog_") + name);
    atelier_.dialog = Dialog::none;
    settle();
  }
}

// Little clay in a small window: it is the viewport that is looked at.
class Views : public Panels {
 protected:
  Views() : Panels(20, {900, 560}) {}
};

TEST_F(Views, looks) {
  carve();
  ViewOptions& options = atelier_.options;
  const ViewOptions plain = options;
  const auto expect = [&](const char* name) {
    expectAsItWas(name, What::viewport);
    options = plain;
  };
  for (const auto& [mode, name] :
       std::initializer_list<std::pair<Mode, const char*>>{{Mode::glaze, "look_glaze"},
                                                           {Mode::plastic, "look_plastic"},
                                                           {Mode::metal, "look_metal"},
                                                           {Mode::matcap, "look_matcap"}}) {
    options.look.mode = mode;
    expect(name);
  }
  options.look.edges = true;
  expect("look_wireframe");
  options.look.shading = Shading::flat;
  expect("look_flat");
  options.box = options.grid = true;
  expect("look_box_and_grid");
  atelier_.mouseMoves = Moves::light;
  expect("look_light_handles");
  atelier_.mouseMoves = Moves::scene;
}

// A ball into which another was pushed, from above: terraces all round, and none.
TEST_F(Views, smoothedClay) {
  ToolOperation ball;
  ball.shape.radii = glm::dvec3(8);
  ActionOperation push;
  push.action.kind = ActionKind::push;
  StrokeOperation down;
  down.stroke.points = {{{0, 30, 0}, 1}, {{0, 15, 0}, 1}};
  const HoldOperation below{{-30, -30, -30}, {30, -10, 30}};  // else all of it would move as it is
  for (const Operation& each :
       {Operation(ball), Operation(below), Operation(push), Operation(down)})
    atelier_.apply(each);
  atelier_.view.turnTo(0.42, 0.6);
  still();
  const Image sharp = seen(picture("look_sharp"), What::viewport);
  atelier_.options.smoothed = true;
  expectAsItWas("look_smoothed", What::viewport);
  EXPECT_GT(worstBlock(seen(picture("look_smoothed"), What::viewport), sharp), 8);
}

TEST_F(Views, stereo) {
  carve();
  Stereo& stereo = atelier_.options.stereo;
  for (const auto& [mode, name] : std::initializer_list<std::pair<StereoMode, const char*>>{
           {StereoMode::sideBySide, "stereo_side_by_side"},
           {StereoMode::rowInterlaced, "stereo_rows"},
           {StereoMode::anaglyph, "stereo_anaglyph"}}) {
    stereo.mode = mode;
    stereo.eyeDistance = .06;
    expectAsItWas(name, mode == StereoMode::rowInterlaced ? What::middle : What::viewport);
  }
}

TEST_F(Views, dataStructure) {
  atelier_.run(Command::newEmpty);
  settle();
  FillOperation ball;
  ball.primitive.radii = glm::dvec3(7);
  atelier_.apply(ball);
  settle();
  atelier_.frameAll();
  for (const auto& [structure, name] : std::initializer_list<std::pair<Structure, const char*>>{
           {Structure::cubes, "structure_all_cubes"},
           {Structure::crossingCubes, "structure_crossing_cubes"}}) {
    atelier_.showStructure(structure);
    expectAsItWas(name, What::viewport);
  }
}

TEST_F(Views, referencePicture) {
  testing::Folder folder;
  Image chart(64, 48);
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x)
      chart.at(x, y) = {std::uint8_t(4 * x), std::uint8_t(5 * y), std::uint8_t(x / 8 % 2 * 200),
                        255};
  writePng(folder / "chart.png", chart);
  atelier_.addReference(folder / "chart.png");
  settle();
  expectAsItWas("reference", What::viewport);
  resize({900, 1000});
  settle();
  expectSection("References", "section_references");
}

TEST_F(Views, historyWithComparison) {
  carve();
  const auto history = atelier_.status().history;
  atelier_.goTo(history->steps.front().number);
  settle();
  carve();
  atelier_.historyShown = true;
  atelier_.compareWith(atelier_.status().history->steps[1].number);
  still();
  picture("history_comparison");                          // its times are now
  expectAsItWas("history_comparison", What::comparison);  // above the strip, not under it
}

TEST_F(Panels, scales) {
  resize({1920, 1080});
  interface_.setScale(1.2f);
  expectAsItWas("start_1920", What::window);
  resize({2560, 1600});
  interface_.setScale(2);
  expectAsItWas("start_scale_2", What::window);
  resize({900, 560});
  expectAsItWas("start_small", What::window);
}

}  // namespace
}  // namespace bozzetto::ui
