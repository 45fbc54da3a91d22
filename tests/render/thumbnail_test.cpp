// The picture that a scene carries shows its clay, whatever the clay's size, in its own colours.
#include "bozzetto/render/thumbnail.hpp"

#include <gtest/gtest.h>

#include "bozzetto/render/png.hpp"
#include "bozzetto/tool/fill.hpp"

namespace bozzetto {
namespace {

Clay halfRedBall(double radius) {
  Clay clay;
  for (const double side : {-1.0, 1.0}) {
    Edit<CornerBlock<8>> edit(clay.tree);
    Primitive primitive;
    primitive.centre = {side * radius / 4, 0, 0};
    primitive.radii = glm::dvec3(radius);
    primitive.colour = side < 0 ? Colour{200, 30, 20} : Colour{30, 40, 200};
    fill(edit, clay.scale, primitive);
    edit.commit();
  }
  return clay;
}

// More of the one than of the other by a factor, in the middle half of a side of the picture.
void expectColours(const Image& image) {
  const Image::Pixel left = image.at(60, 128), right = image.at(196, 128);
  EXPECT_GT(left[0], 2 * left[2]);
  EXPECT_GT(right[2], 2 * right[0]);
}

TEST(Thumbnail, showsTheClay) {
  const Bytes png = thumbnailOf(halfRedBall(30));
  const Image image = decodePng(png);
  EXPECT_EQ(image.width, 256);
  EXPECT_EQ(image.height, 256);
  expectColours(image);
  EXPECT_LT(png.size(), 150000u);
}

TEST(Thumbnail, showsLargeClayByACoarserCopy) {
  const Clay large = halfRedBall(220);
  ASSERT_GT(large.tree.nodeCount(), 4000u);
  expectColours(decodePng(thumbnailOf(large)));
}

TEST(Thumbnail, ofNothingIsNone) { EXPECT_TRUE(thumbnailOf(Clay()).empty()); }

}  // namespace
}  // namespace bozzetto
