#include "bozzetto/render/png.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "bozzetto/base/error.hpp"
#include "bozzetto/base/file.hpp"
#include "support/folder.hpp"

namespace bozzetto {
namespace {

Image pattern(int width, int height, std::uint8_t opacity) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.at(x, y) = {std::uint8_t(x * 7), std::uint8_t(y * 5), std::uint8_t(x ^ y), opacity};
    }
  }
  return image;
}

TEST(Png, EveryPixelComesBack) {
  for (const std::uint8_t opacity : {std::uint8_t{255}, std::uint8_t{90}}) {
    const Image image = pattern(37, 21, opacity);
    const Image back = decodePng(encodePng(image));
    EXPECT_EQ(back.width, 37);
    EXPECT_EQ(back.height, 21);
    EXPECT_EQ(back.pixels, image.pixels);
  }
}

TEST(Png, OpaqueImagesCarryNoOpacity) {
  constexpr std::size_t kColourType = 25;  // in the header chunk
  EXPECT_EQ(encodePng(pattern(8, 8, 255))[kColourType], std::byte{2});
  EXPECT_EQ(encodePng(pattern(8, 8, 254))[kColourType], std::byte{6});
}

TEST(Png, CutAtEveryByteIsAnError) {
  const Bytes whole = encodePng(pattern(9, 6, 255));
  for (std::size_t length = 0; length < whole.size(); ++length) {
    EXPECT_THROW(decodePng(std::span(whole).first(length), "cut.png"), Error) << length;
  }
}

TEST(Png, DamagedBytesNeverCrash) {
  const Bytes whole = encodePng(pattern(9, 6, 255));
  for (std::size_t at = 0; at < whole.size(); ++at) {
    Bytes damaged = whole;
    damaged[at] ^= std::byte{0x5a};
    try {
      decodePng(damaged);
    } catch (const Error&) {
    }
  }
}

TEST(Png, HugeSizeInFewBytesIsRefused) {
  Bytes bytes = encodePng(pattern(4, 4, 255));
  bytes[18] = std::byte{0x3f};  // width 16132
  EXPECT_THROW(decodePng(bytes), Error);
}

TEST(Png, FilesAndErrorsNameThePath) {
  const testing::Folder folder;
  const auto path = folder / "a.png";
  const Image image = pattern(5, 5, 255);
  writePng(path, image);
  EXPECT_EQ(readPng(path).pixels, image.pixels);
  writeFile(path, std::as_bytes(std::span("not a picture")));
  try {
    readPng(path);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos);
  }
  EXPECT_THROW(encodePng(Image()), Error);
}

}  // namespace
}  // namespace bozzetto
