// Keys: names, profiles, and what the user changes.
#include "ui/keymap.hpp"

#include <gtest/gtest.h>

#include <set>

namespace bozzetto::ui {
namespace {

TEST(Keys, everyChordSurvivesItsText) {
  for (int code = 1; code <= int(KeyCode::last); ++code) {
    for (int bits = 0; bits < 8; ++bits) {
      const Chord chord{static_cast<KeyCode>(code),
                        {(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0}};
      const std::string text = toText(chord);
      if (text.empty()) continue;
      ASSERT_EQ(chordNamed(text), chord) << text;
    }
  }
  EXPECT_EQ(toText(Chord{letter('Z'), {.ctrl = true, .shift = true}}), "Ctrl+Shift+Z");
  EXPECT_FALSE(chordNamed("").has_value());
  EXPECT_FALSE(chordNamed("Ctrl+").has_value());
  EXPECT_FALSE(chordNamed("Banana").has_value());
}

TEST(Commands, theTableIsInOrderAndComplete) {
  std::set<std::string_view> ids;
  ASSERT_EQ(commandTable().size(), std::size_t(Command::count));
  for (std::size_t n = 0; n < commandTable().size(); ++n) {
    const CommandRow& row = commandTable()[n];
    EXPECT_EQ(std::size_t(row.command), n) << row.id;
    EXPECT_TRUE(ids.insert(row.id).second) << row.id;
    EXPECT_FALSE(row.title.empty());
    EXPECT_TRUE(row.tip.ends_with('.')) << row.tip;
  }
}

// Every default key is understood, and none means two things.
class Profiles : public ::testing::TestWithParam<KeyProfile> {};

TEST_P(Profiles, noKeyMeansTwoThings) {
  Keymap map;
  map.setProfile(GetParam());
  std::set<std::string> seen;
  for (const CommandRow& row : commandTable()) {
    const std::string_view text = GetParam() == KeyProfile::blender ? row.blender : row.zbrush;
    const std::vector<Chord> chords = chordsOf(text);
    EXPECT_EQ(toText(chords), text) << row.id;
    for (const Chord& chord : chords) {
      EXPECT_TRUE(seen.insert(toText(chord)).second) << row.id << ": " << toText(chord);
      EXPECT_EQ(map.find(chord), row.command);
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Both, Profiles,
                         ::testing::Values(KeyProfile::blender, KeyProfile::zbrush));

TEST(Keymap, theProfilesInvertWithTheirOwnKey) {
  Keymap map;
  EXPECT_TRUE(map.inverts({.ctrl = true}));
  EXPECT_FALSE(map.inverts({.alt = true}));
  EXPECT_TRUE(map.smooths({.shift = true}));
  map.setProfile(KeyProfile::zbrush);
  EXPECT_FALSE(map.inverts({.ctrl = true}));
  EXPECT_TRUE(map.inverts({.alt = true}));
  EXPECT_TRUE(map.smooths({.shift = true}));
  EXPECT_FALSE(map.smooths({.ctrl = true, .shift = true}));
}

TEST(Keymap, aKeyThatIsGivenAwayIsTakenFromItsOwner) {
  Keymap map;
  const Chord x{letter('X'), {}};
  map.bind(Command::fullScreen, {x});
  EXPECT_EQ(map.find(x), Command::fullScreen);
  EXPECT_TRUE(map.chords(Command::mirrorX).empty());
  map.resetToDefaults();
  EXPECT_EQ(map.find(x), Command::mirrorX);
}

TEST(Keymap, changesAreKeptAsText) {
  Keymap map;
  map.bind(Command::undo, chordsOf("F5, Ctrl+U"));
  Keymap other;
  other.setChanges(map.changes());
  EXPECT_EQ(other.chords(Command::undo), chordsOf("F5, Ctrl+U"));
  other.setChanges({{"undo", "nonsense"}, {"no_such_command", "F6"}});
  EXPECT_TRUE(other.chords(Command::undo).empty());
}

}  // namespace
}  // namespace bozzetto::ui
