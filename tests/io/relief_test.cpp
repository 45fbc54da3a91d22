// Grey pictures and text as clay.
#include <gtest/gtest.h>
#include <png.h>

#include <cstdio>
#include <filesystem>

#include "bozzetto/base/file.hpp"
#include "bozzetto/io/relief.hpp"
#include "support/folder.hpp"

namespace bozzetto {
namespace {

namespace fs = std::filesystem;

GreyImage disc(int size) {
  GreyImage image{size, size, {}};
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const double dx = x + 0.5 - size / 2.0, dy = y + 0.5 - size / 2.0;
      image.grey.push_back(dx * dx + dy * dy < size * size / 9.0 ? 1.0f : 0.0f);
    }
  return image;
}

TEST(Relief, brightPartsStandOnThePlane) {
  const Clay clay = relief(disc(96), {60, 10, 1, {}});
  EXPECT_EQ(validate(clay), std::nullopt);
  EXPECT_EQ(clay.value({0, 0, 0}), 0.5f);
  EXPECT_EQ(clay.value({0, 0, 5}), 1);
  EXPECT_NEAR(clay.value({0, 0, 10}), 0.5, 1e-6);
  EXPECT_EQ(clay.value({0, 0, 12}), 0);
  EXPECT_EQ(clay.value({25, 0, 1}), 0);
  EXPECT_NEAR(double(massUnits(clay)) * kMassUnit, 3.14159 * 400 * 10, 700);
}

TEST(Relief, upIsUpAndRightIsRight) {
  GreyImage image{40, 20, std::vector<float>(800, 0)};
  for (int y = 2; y < 8; ++y)
    for (int x = 30; x < 38; ++x) image.grey[std::size_t(y * 40 + x)] = 1;  // top right
  const Clay clay = relief(image, {40, 6, 1, {}});
  EXPECT_EQ(clay.value({14, 5, 3}), 1);
  EXPECT_EQ(clay.value({-14, 5, 3}), 0);
  EXPECT_EQ(clay.value({14, -5, 3}), 0);
}

// However coarse it is, a white picture is a slab of its size.
TEST(Relief, picturesReachTheirBorder) {
  for (const int pixels : {1, 8, 64, 200}) {
    const auto count = std::size_t(pixels * pixels);
    const Clay clay = relief({pixels, pixels, std::vector<float>(count, 1.0f)}, {40, 6, 1, {}});
    EXPECT_NEAR(double(massUnits(clay)) * kMassUnit / (40 * 40 * 6.0), 1, 0.1) << pixels;
    EXPECT_EQ(clay.value({18, 18, 3}), 1) << pixels;
    EXPECT_EQ(clay.value({22, 0, 3}), 0) << pixels;
  }
}

TEST(Relief, refusesWhatIsNone) {
  EXPECT_THROW(relief(GreyImage{200, 1, std::vector<float>(200, 1.0f)}, {8, 8, 1, {}}), Error);
  EXPECT_THROW(relief(disc(8), {0, 1, 1, {}}), Error);
  EXPECT_THROW(relief(disc(8), {1e6, 1e6, 1, {}}), Error);
  EXPECT_THROW(relief(GreyImage{2, 2, {0, 0, 0, 0}}, {8, 8, 1, {}}), Error);
}

TEST(Text, drawsLettersInOrder) {
  const GreyImage one = drawText("I"), two = drawText("II"), blank = drawText("I I");
  EXPECT_GT(two.width, one.width);
  EXPECT_GT(blank.width, two.width);
  EXPECT_EQ(one.height, two.height);
  EXPECT_EQ(one.at(0, 0), 0);
  EXPECT_GT(one.at(one.width / 2, one.height / 2), 0.6f);
}

// Along a slanted stroke the outline is straight: no corner's distance is off by a tenth of a cell.
TEST(Text, sidesAreStraightAndUpright) {
  const GreyImage image = drawText("/");
  const Clay clay = standingText(image, {20.0 * image.width / 128, 6, 0.5, {}});
  EXPECT_EQ(validate(clay), std::nullopt);
  const auto rightOf = [&](int j, int k) {  // where the surface crosses a row
    int i = 60;
    while (clay.value({i, j, k}) < 0.5f) --i;
    const float in = clay.value({i, j, k}), out = clay.value({i + 1, j, k});
    return double(i) + double((in - 0.5f) / (in - out));
  };
  const double slope = (rightOf(15, 6) - rightOf(-15, 6)) / 30;
  EXPECT_GT(slope, 0.2);
  for (int j = -15; j <= 15; ++j) {
    EXPECT_NEAR(rightOf(j, 6), rightOf(-15, 6) + slope * (j + 15), 0.1);
    EXPECT_EQ(rightOf(j, 5), rightOf(j, 7));
  }
}

TEST(Text, refusesWhatIsNone) {
  EXPECT_THROW(drawText(""), Error);
  EXPECT_THROW(drawText("   "), Error);
  EXPECT_THROW(drawText("a\nb"), Error);
  EXPECT_THROW(drawText("\xff"), Error);
  EXPECT_THROW(drawText("\xc3"), Error);
  EXPECT_THROW(drawText("\u05e9"), Error) << "would stand in the wrong order";
  EXPECT_THROW(drawText(std::string(300, 'a')), Error);
  EXPECT_THROW(drawText("A", {.font = "no such font"}), Error);
  EXPECT_THROW(drawText("A", {.font = {}, .pixels = 100000}), Error);
}

// A grey ramp, 16 bits.
Bytes rampPng() {
  Bytes out;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  const auto append = [](png_structp writer, png_bytep data, png_size_t count) {
    auto* bytes = static_cast<Bytes*>(png_get_io_ptr(writer));
    const auto* raw = reinterpret_cast<const std::byte*>(data);
    bytes->insert(bytes->end(), raw, raw + count);
  };
  png_set_write_fn(png, &out, append, nullptr);
  png_set_IHDR(png, info, 256, 2, 16, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  std::vector<png_byte> row;
  for (int x = 0; x < 256; ++x) {
    row.push_back(png_byte(x));
    row.push_back(png_byte(x));
  }
  for (int y = 0; y < 2; ++y) png_write_row(png, row.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return out;
}

TEST(GreyPng, readsSixteenBitsAndSurvivesEveryCut) {
  const testing::Folder folder;
  const fs::path path = folder / "ramp.png";
  const Bytes ramp = rampPng();
  writeFile(path, ramp);
  const GreyImage image = readGreyPng(path);
  ASSERT_EQ(image.width, 256);
  for (int x = 0; x < 256; ++x) EXPECT_NEAR(image.at(x, 1), x / 255.0, 1e-5);
  for (std::size_t size = 0; size + 16 < ramp.size(); ++size) {
    writeFile(path, std::span(ramp).first(size));
    EXPECT_THROW(readGreyPng(path), Error) << size;
  }
  Bytes wide = ramp;
  wide[18] = std::byte{0x7f};  // a width of millions, its checksum wrong too
  writeFile(path, wide);
  EXPECT_THROW(readGreyPng(path), Error);
}

}  // namespace
}  // namespace bozzetto
