// What is kept between sessions, and what bad files do to it: nothing.
#include "ui/settings.hpp"

#include <gtest/gtest.h>

#include "support/folder.hpp"
#include "ui/file_browser.hpp"
#include "ui/null_window.hpp"

namespace bozzetto::ui {
namespace {

Settings some() {
  Settings settings;
  settings.profile = KeyProfile::zbrush;
  settings.keys = {{"undo", "F5"}};
  settings.recent = {"/a/b.bzt", "/c d/ü.bzt"};
  settings.orbit = OrbitStyle::trackball;
  settings.scale = 1.5;
  settings.pressureGamma = 2;
  settings.pressureSize = true;
  return settings;
}

TEST(Settings, surviveTheirText) { EXPECT_EQ(parseSettings(toText(some())), some()); }

TEST(Settings, damageKeepsWhatCanBeRead) {
  EXPECT_EQ(parseSettings(""), Settings{});
  EXPECT_EQ(parseSettings("[1,2"), Settings{});
  EXPECT_EQ(parseSettings(R"({"scale":"big","keys":[1],"orbit":3,"recent":{"a":1}})"), Settings{});
  EXPECT_EQ(parseSettings(R"({"scale":900,"puck_speed":-3})"), Settings{});
  EXPECT_EQ(parseSettings(R"({"profile":"zbrush","scale":[]})").profile, KeyProfile::zbrush);
}

TEST(Settings, everyPrefixOfAFileIsHarmless) {
  const std::string text = toText(some());
  for (std::size_t n = 0; n < text.size(); ++n) parseSettings(text.substr(0, n));
}

TEST(Settings, theLastSceneComesFirstAndOnce) {
  Settings settings;
  for (int n = 0; n < 20; ++n) settings.remember("/x/" + std::to_string(n) + ".bzt");
  settings.remember("/x/15.bzt");
  EXPECT_EQ(settings.recent.size(), 12u);
  EXPECT_EQ(settings.recent.front(), "/x/15.bzt");
  EXPECT_EQ(std::count(settings.recent.begin(), settings.recent.end(), "/x/15.bzt"), 1);
}

TEST(Settings, goToDiskAndBack) {
  const testing::Folder place;
  const std::filesystem::path folder = place / "deeper";
  EXPECT_EQ(readSettings(folder), Settings{});
  writeSettings(folder, some());
  EXPECT_EQ(readSettings(folder), some());
}

TEST(Settings, areKeptWhileTheWindowIsOpen) {
  const StateFolder state;
  const testing::Folder folder;
  Atelier atelier(Atelier::Options{{}, folder.path(), [] {}, 8});
  atelier.keymap.bind(Command::newBlock, chordsOf("F8"));
  atelier.setTime(5);
  atelier.poll();
  EXPECT_EQ(readSettings(folder.path()).keys.at("new_block"), "F8");
}

TEST(FileBrowser, showsFoldersFirstAndWhatIsWanted) {
  namespace fs = std::filesystem;
  const testing::Folder folder;
  fs::create_directories(folder / "zoo");
  fs::create_directories(folder / ".hidden");
  for (const char* name : {"b.bzt", "A.BZT", "c.txt"})
    std::fclose(std::fopen((folder / name).c_str(), "w"));
  FileBrowser browser;
  browser.open(folder.path(), {".bzt"});
  std::vector<std::string> names;
  for (const FileEntry& entry : browser.entries()) names.push_back(entry.name);
  EXPECT_EQ(names, (std::vector<std::string>{"zoo", "A.BZT", "b.bzt"}));
  EXPECT_EQ(browser.find("B"), 2);
  EXPECT_EQ(browser.find("q"), -1);
  browser.enter(folder / "zoo");
  EXPECT_TRUE(browser.entries().empty());
  browser.up();
  EXPECT_EQ(browser.folder(), folder.path());
  EXPECT_EQ(browser.resolve("x.bzt"), folder / "x.bzt");
  EXPECT_EQ(browser.resolve("/tmp/x"), fs::path("/tmp/x"));
}

}  // namespace
}  // namespace bozzetto::ui
