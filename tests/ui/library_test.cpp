// The user's own library on the shelf: names, tags, and files that are damaged.
#include <fstream>

#include "bozzetto/scene/scene_file.hpp"
#include "bozzetto/sculptor/user_tools.hpp"
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
  edit.set({0, 0, 0}, {1, 0});
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

}  // namespace
}  // namespace bozzetto::ui
