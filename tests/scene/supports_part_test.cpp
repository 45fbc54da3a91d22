// Supports in a scene file: sculpted ones bring their sculpture, each once; nothing else is read.
#include <gtest/gtest.h>

#include "bozzetto/scene/scene_file.hpp"
#include "bozzetto/scene/support_bytes.hpp"
#include "scene/parts_codec.hpp"
#include "scene/scenes.hpp"

namespace bozzetto {
namespace {

std::shared_ptr<const Sculpture> smallBall(float radius) {
  Clay clay = testing::ball<8>(radius, {}, {9, 8, 7});
  clay.scale = {0.5, 0.5f};
  return std::make_shared<const Sculpture>(std::move(clay));
}

std::vector<clay::Support> someSupports() {
  const auto ball = smallBall(5);
  return {{Shape::box, {1, 2, 3}, {4, 5, 6}, {0, 1, 0, 0}},
          {Shape::freeform, {7, 8, 9}, {3, 3, 3}, {1, 0, 0, 0}, ball},
          {Shape::freeform, {0, 0, 0}, {3, 4, 9}, {0.5, 0.5, 0.5, 0.5}, smallBall(3)},
          {Shape::freeform, {-7, 8, 9}, {6, 6, 6}, {1, 0, 0, 0}, ball}};
}

TEST(SupportsPart, SavedAndLoadedWithTheirSculptures) {
  const testing::Folder folder;
  Document document;
  document.parts.supports = someSupports();
  saveScene(folder / "table.bzt", document);
  const auto loaded = loadScene(folder / "table.bzt").parts.supports;
  EXPECT_EQ(loaded, document.parts.supports);
  EXPECT_EQ(loaded[1].sculpture, loaded[3].sculpture) << "one sculpture, kept once";
  EXPECT_NE(loaded[1].sculpture, loaded[2].sculpture);
  EXPECT_FALSE(loaded[1] == loaded[2]);
}

TEST(SupportsPart, OneWithoutASculptureIsNotSaved) {
  const testing::Folder folder;
  Document document;
  document.parts.supports = {{Shape::freeform, {0, 0, 0}, {3, 3, 3}}};
  EXPECT_THROW(saveScene(folder / "none.bzt", document), Error);
  EXPECT_FALSE(std::filesystem::exists(folder / "none.bzt"));
}

TEST(SupportsPart, CutOffOrChangedBytesAreAnErrorOrAnotherSupport) {
  const Bytes whole = encodeSupports(someSupports());
  EXPECT_EQ(decodeSupports(whole, "test"), someSupports());
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_THROW(decodeSupports(std::span(whole).first(length), "test"), Error) << length;
  for (std::size_t at = 0; at < whole.size(); ++at) {
    Bytes changed = whole;
    changed[at] ^= std::byte{0x81};
    try {
      for (const clay::Support& support : decodeSupports(changed, "test"))
        EXPECT_EQ(support.sculpture != nullptr, support.shape == Shape::freeform);
    } catch (const Error&) {
    }
  }
}

}  // namespace
}  // namespace bozzetto
