// Painted stiffness in a scene file: what is saved comes back, and nothing else is read.
#include <gtest/gtest.h>

#include "bozzetto/scene/clay_bytes.hpp"
#include "bozzetto/scene/scene_file.hpp"
#include "bozzetto/scene/stiffness_bytes.hpp"
#include "scene/scenes.hpp"

namespace bozzetto {
namespace {

clay::Stiffness somePaint() {
  Clay painted = testing::ball<8>(3, {}, {255, 255, 255});
  painted.scale = {0.5, 0.5f};
  return clay::stiffnessOf(std::move(painted));
}

TEST(StiffnessPart, SavedAndLoaded) {
  const testing::Folder folder;
  Document document;
  document.parts.stiffness = somePaint();
  saveScene(folder / "soft.bzt", document);
  EXPECT_EQ(loadScene(folder / "soft.bzt").parts, document.parts);
  SceneFile file;
  document = file.load(folder / "soft.bzt");
  document.parts.stiffness = {};
  file.save(folder / "soft.bzt", document);
  EXPECT_FALSE(loadScene(folder / "soft.bzt").parts.stiffness.any());
}

TEST(StiffnessPart, OffsetsBeyondOneAreRefused) {
  Clay painted = *somePaint().painted;
  Edit<CornerBlock<8>> edit(painted.tree);
  edit.write({0, 0, 0}).value[0] = 1.25f;
  edit.commit();
  const testing::Folder folder;
  Document document;
  document.parts.stiffness = clay::stiffnessOf(painted);
  EXPECT_THROW(saveScene(folder / "none.bzt", document), Error);
  EXPECT_FALSE(std::filesystem::exists(folder / "none.bzt"));
  EXPECT_THROW(decodeStiffness(encodeClay(painted), "test"), Error);
  EXPECT_THROW(decodeStiffness(encodeClay({}), "test"), Error) << "nothing painted";
}

TEST(StiffnessPart, CutOffOrChangedBytesAreAnErrorOrOtherPaint) {
  const Bytes whole = encodeClay(*somePaint().painted);
  EXPECT_EQ(decodeStiffness(whole, "test"), somePaint());
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_THROW(decodeStiffness(std::span(whole).first(length), "test"), Error) << length;
  for (std::size_t at = 0; at < whole.size(); ++at) {
    Bytes changed = whole;
    changed[at] ^= std::byte{0x81};
    try {
      const clay::Stiffness read = decodeStiffness(changed, "test");
      EXPECT_EQ(validate(*read.painted), std::nullopt) << at;
      clay::requireValid(read, "test");
    } catch (const Error&) {
    }
  }
}

}  // namespace
}  // namespace bozzetto
