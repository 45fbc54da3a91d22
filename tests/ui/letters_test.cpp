// Letters beyond Latin: from our own face, else from any font that is installed.
#include "ui/letters.hpp"

#include "ui/null_window.hpp"
#include "ui/theme.hpp"

namespace bozzetto::ui {
namespace {

bool has(ImWchar letter) { return fonts().regular->FindGlyphNoFallback(letter) != nullptr; }

TEST_F(Null, namesBeyondLatinAreShown) {
  EXPECT_FALSE(has(0x0416)) << "starting costs nothing for them";
  atelier_.say(Message::Kind::note, "Saved Жук, λόγος and \u05D0");
  settle();
  for (const int letter : {0x0416, 0x0436, 0x03BB, 0x03CC})
    EXPECT_TRUE(has(ImWchar(letter))) << letter << ": of Inter";
  EXPECT_TRUE(has(0x0424)) << "the alphabet with it";
  const bool installed = !fontsWith({0x05D0}).empty();
  EXPECT_EQ(has(0x05D0), installed) << "of another font";
  EXPECT_FALSE(lettersAreNew());
}

TEST_F(Null, whatNoFontHasIsOnePlaceholder) {
  lettered("\uF123 \U0001F600 \xFF\xFE");
  settle();
  EXPECT_FALSE(has(0xF123));
  EXPECT_EQ(fonts().regular->FindGlyph(0xF123), fonts().regular->FallbackGlyph);
  EXPECT_EQ(fonts().regular->FallbackChar, kPlaceholder);
}

TEST(Letters, textsAreCutBetweenCharacters) {
  ImGui::CreateContext();
  useTheme(1);
  const std::string text = "éééééééé";
  const std::string cut = fitted(fonts().regular, text, textWidth(fonts().regular, "éééé…") + .5f);
  EXPECT_EQ(cut, "éééé…");
  ImGui::DestroyContext();
}

}  // namespace
}  // namespace bozzetto::ui
