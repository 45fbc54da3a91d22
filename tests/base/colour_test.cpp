#include "bozzetto/base/colour.hpp"

#include <gtest/gtest.h>

#include "bozzetto/base/error.hpp"

namespace bozzetto {
namespace {

TEST(Colour, KnownTexts) {
  EXPECT_EQ(parseColour("#000000"), (Colour{0, 0, 0}));
  EXPECT_EQ(parseColour("#ffffff"), (Colour{255, 255, 255}));
  EXPECT_EQ(parseColour("#c8643C"), (Colour{0xc8, 0x64, 0x3c}));
  EXPECT_EQ(toText(Colour{0xac, 0x70, 0x52}), "#ac7052");
  EXPECT_EQ(toText(Colour{0, 1, 2}), "#000102");
}

TEST(Colour, EveryChannelValueComesBack) {
  for (int value = 0; value < 256; ++value) {
    const auto v = static_cast<std::uint8_t>(value);
    const auto w = static_cast<std::uint8_t>(255 - value);
    for (const Colour colour : {Colour{v, w, 0}, Colour{0, v, w}, Colour{w, 0, v}})
      EXPECT_EQ(parseColour(toText(colour)), colour);
  }
}

TEST(Colour, AnythingElseIsAnError) {
  for (const char* text : {"", "#", "#fff", "#ffff", "ffffff", "#fffffff", "#ggffff", "#fffffg",
                           "#-1ffff", "#+1ffff", "# fffff", "#0xffff", "#ffffff ", "red"})
    EXPECT_THROW(parseColour(text), Error) << "'" << text << "'";
}

TEST(Colour, ErrorQuotesOnlyTheBeginningOfLongText) {
  try {
    parseColour(std::string(100000, 'x'));
    FAIL();
  } catch (const Error& error) {
    EXPECT_LT(std::string(error.what()).size(), 120u);
  }
}

}  // namespace
}  // namespace bozzetto
