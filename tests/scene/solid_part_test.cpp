// The solid in a scene file: there and back, gone again, refused when it is none.
#include <gtest/gtest.h>

#include "bozzetto/scene/scene_file.hpp"
#include "bozzetto/solid/solid_codec.hpp"
#include "support/folder.hpp"

namespace bozzetto {
namespace {

Bytes someSolid() {
  Solid solid;
  NamedLattice made = makeBlock({{2, 1, 3}, glm::dvec3(4), glm::dvec3(1), {}});
  solid.control = std::move(made.lattice);
  solid.names = std::move(made.names);
  return encodeSolid(std::make_shared<const Solid>(solid));
}

TEST(SolidPart, SavedLoadedAndTakenOutAgain) {
  const testing::Folder folder;
  const auto path = folder / "solid.bzt";
  Document document;
  document.parts.solid = someSolid();
  saveScene(path, document);
  EXPECT_EQ(loadScene(path).parts.solid, document.parts.solid);
  document.parts.solid.clear();
  saveScene(path, document);
  EXPECT_TRUE(loadScene(path).parts.solid.empty());
  document.parts.solid = {std::byte{1}, std::byte{2}};
  EXPECT_THROW(saveScene(path, document), Error);
  EXPECT_TRUE(loadScene(path).parts.solid.empty());
}

}  // namespace
}  // namespace bozzetto
