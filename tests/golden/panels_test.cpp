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
  enum class What { window, properties };

  // One quality, however fast the machine is.
  Panels() { atelier_.options.quality = Quality::light; }

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
  void expectAsItWas(const std::string& name, What what) {
    still();
    const Image whole = picture(name);
    const bool all = what == What::window;
    const Image now = all ? shrunk(whole, whole.width / 320)
                          : shrunk(cropped(whole, interface_.layout().properties), 2);
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
  testing::Folder folder;
  for (const char* name : {"faun.bzt", "hand study.bzt", "horns.bzt"}) {
    writeFile(folder / name, Bytes(123456));
  }
  fs::create_directory(folder / "older");
  atelier_.settings.folder = folder.path();
  for (const auto& [dialog, name] : std::initializer_list<std::pair<Dialog, const char*>>{
           {Dialog::help, "help"}, {Dialog::unsaved, "unsaved"}}) {
    atelier_.dialog = dialog;
    expectAsItWas(std::string("dialog_") + name, What::window);
    atelier_.dialog = Dialog::none;
    settle();
  }
  // These name folders of this machine.
  for (const auto& [dialog, name] :
       std::initializer_list<std::pair<Dialog, const char*>>{{Dialog::open, "open"},
                                                             {Dialog::saveAs, "save_as"},
                                                             {Dialog::import, "import"},
                                                             {Dialog::exportMesh, "export"},
                                                             {Dialog::turntable, "turntable"},
                                                             {Dialog::recovered, "recovered"},
                                                             {Dialog::leftBehind, "left_behind"}}) {
    atelier_.dialog = dialog;
    still();
    picture(std::string("dialog_") + name);
    atelier_.dialog = Dialog::none;
    settle();
  }
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
