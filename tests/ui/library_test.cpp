// The user's own library on the shelf: names, tags, and files that are damaged.
#include <algorithm>
#include <atomic>
#include <fstream>
#include <thread>

#include "bozzetto/scene/scene_file.hpp"
#include "bozzetto/sculptor/user_tools.hpp"
#include "bozzetto/tool/fill.hpp"
#include "ui/shelf_window.hpp"

namespace bozzetto::ui {
namespace {

namespace fs = std::filesystem;

// Recordings that say shelf:leaf would get it.
TEST_F(Shelf, aStartersCopyNeedsANameOfItsOwn) {
  atelier_.keepForUser(card("leaf")->entry, "leaf");
  settle();
  EXPECT_FALSE(fs::exists(userToolFolder() / "leaf.bzt"));
  atelier_.keepForUser(card("leaf")->entry, "leaf 2");
  settle();
  ASSERT_NE(card("leaf 2"), nullptr);
  EXPECT_EQ(card("leaf 2")->entry.place, ToolEntry::Place::user);
}

TEST_F(Shelf, tagsOfTheLibrarysToolsChangeAndAllElseStays) {
  fs::create_directories(userToolFolder());
  Document document;
  Edit<CornerBlock<8>> edit(document.field.tree);
  fill<8>(edit, document.field.scale, Primitive{});
  edit.commit();
  document.parts.settings["lamp"] = "bright";
  saveScene(userToolFolder() / "bust.bzt", document);
  atelier_.listShelf();
  settle();
  ASSERT_NE(card("bust"), nullptr);
  atelier_.renameTool(card("bust")->entry, "bust", {"face", "old"});
  settle();
  ASSERT_NE(card("bust"), nullptr);
  EXPECT_EQ(card("bust")->entry.tags, (std::vector<std::string>{"face", "old"}));
  atelier_.renameTool(card("bust")->entry, "head", {"face"});
  settle();
  EXPECT_EQ(card("bust"), nullptr);
  const Document kept = loadScene(userToolFolder() / "head.bzt");
  EXPECT_EQ(kept.parts.settings.at("lamp"), "bright");
  EXPECT_EQ(fieldHash(kept.field), fieldHash(document.field));
}

TEST_F(Shelf, damagedFilesOfTheLibraryAreShownAndCanBeRemoved) {
  fs::create_directories(userToolFolder());
  std::ofstream(userToolFolder() / "broken.bzt") << "this is no tool";
  ASSERT_EQ(damagedTools().size(), 1u);
  atelier_.listShelf();
  settle();
  ASSERT_NE(card("broken"), nullptr);
  EXPECT_NE(card("broken")->trouble.find("broken.bzt"), std::string::npos);
  EXPECT_EQ(card("leaf")->trouble, "");
  atelier_.shelf.query = "broken";
  settle();
  click(firstCard());
  EXPECT_FALSE(atelier_.sculpt.isFreeform());
  ASSERT_FALSE(atelier_.messages().empty());
  EXPECT_EQ(atelier_.messages().back().text, card("broken")->trouble);
  atelier_.dropTool(card("broken")->entry);
  settle();
  EXPECT_EQ(card("broken"), nullptr);
  EXPECT_FALSE(fs::exists(userToolFolder() / "broken.bzt"));
}

// "letter B" means one of the alphabet, though b is somewhere in that word.
TEST_F(Shelf, searchesMeanTheBeginningsOfWords) {
  const auto found = [&](const char* query) {
    return std::ranges::count_if(atelier_.shelf.cards,
                                 [&](const ShelfCard& each) { return matches(each.entry, query); });
  };
  EXPECT_EQ(found("letter B"), 1);
  EXPECT_GT(found("alph"), 20);
  EXPECT_EQ(found("lphabet"), 0);
}

// Until it is there strokes would be those of the tool before.
TEST_F(Shelf, strokesWaitForAToolAndAnActionChosenMeanwhileStays) {
  const std::uint64_t before = hash();
  moveTo(middle());
  settle();
  std::atomic<bool> held = true;
  atelier_.worker().post([&](ClayDesk&) {
    while (held) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  });
  atelier_.takeTool(card("brick")->entry);
  post(ButtonChanged{Button::left, true});
  post(ButtonChanged{Button::left, false});
  for (int n = 0; n < 4; ++n) frame();
  EXPECT_FALSE(atelier_.messages().empty()) << "it says that it waits";
  atelier_.setTool(ActionKind::stamp);
  held = false;
  settle();
  ASSERT_TRUE(atelier_.sculpt.isFreeform());
  EXPECT_EQ(atelier_.sculpt.action, ActionKind::stamp);
  EXPECT_EQ(hash(), before);
}

}  // namespace
}  // namespace bozzetto::ui
