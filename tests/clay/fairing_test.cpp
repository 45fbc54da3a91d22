// Surfaces where matter comes out: faired without loss, and left alone where they are smooth.
#include "clay/fairing.hpp"

#include "clay/clay_fixture.hpp"

namespace bozzetto::clay::testing {
namespace {

// A region with a slab of clay up to y = 16, its slope over two cells, and room above.
struct Slab {
  Region region{KeyBox{{0, 0, 0}, {47, 47, 47}}};
  std::vector<PlacedTool> none;
  Settings settings;
  StepReport report;
  MovedCells moved;

  Slab() {
    for (std::size_t cell = 0; cell < 48 * 48 * 48; ++cell) {
      const Key key = region.key(cell);
      region.value[cell] = std::clamp(0.5f - 0.5f * static_cast<float>(key.j - 16), 0.0f, 1.0f);
      if (!region.inRim(key)) moved.note(cell);
    }
  }
  float& at(Key key) { return region.value[region.index(key)]; }
  double mass() const {
    double sum = 0;
    for (std::size_t cell = 0; cell < 48 * 48 * 48; ++cell) sum += region.value[cell];
    return sum;
  }
  /// Of the columns along a line, between its ends: the highest less the lowest.
  float unevenness(int k) {
    float least = 100, most = 0;
    for (int i = 16; i < 32; ++i) {
      float height = 0;
      for (int j = 9; j < 30; ++j) height += at({i, j, k});
      least = std::min(least, height);
      most = std::max(most, height);
    }
    return most - least;
  }
  void fair(int passes) {
    Work work{region, none, none, {}, settings, 0.5f, 0, report};
    Fairing().run(work, moved, passes);
  }
};

TEST(Fairing, LeavesAPlaneAsItIs) {
  Slab slab;
  slab.fair(20);
  for (int j = 10; j < 24; ++j)
    EXPECT_EQ(slab.at({24, j, 24}),
              std::clamp(0.5f - 0.5f * static_cast<float>(j - 16), 0.0f, 1.0f));
}

// Teeth two cells wide and three high, as blocks leave them, sink into a plane; no matter is lost.
TEST(Fairing, TeethSinkAndKeepTheirMatter) {
  Slab slab;
  for (int i = 9; i < 40; ++i)
    for (int k = 9; k < 40; ++k)
      for (int j = 16; j < 19; ++j)
        if (i / 2 % 2 == 0) slab.at({i, j, k}) = 1;
  const double before = slab.mass();
  slab.fair(60);
  EXPECT_EQ(slab.mass(), before);
  EXPECT_LT(slab.unevenness(24), 0.5);
}

// Along a plate that takes just half of the cells beside it, they are not closed: teeth sink there.
TEST(Fairing, TeethAlongAPlateAtHalfACellSinkToo) {
  Slab slab;
  for (int i = 9; i < 40; ++i)
    for (int j = 9; j < 40; ++j) {
      for (int k = 9; k < 40; ++k) slab.region.cover[slab.region.index({i, j, k})] = k < 24 ? 1 : 0;
      slab.region.cover[slab.region.index({i, j, 24})] = 0.5f;
      for (int k = 9; k < 24; ++k) slab.at({i, j, k}) = 0;
      slab.at({i, j, 24}) = (j < 17 || (j < 19 && i / 2 % 2 == 0)) ? 0.5f : 0.0f;
    }
  const double before = slab.mass();
  slab.fair(60);
  EXPECT_EQ(slab.mass(), before);
  EXPECT_LT(2 * slab.unevenness(24), 0.5);
}

// The papers know nothing of it, nor do cells that no matter came to.
TEST(Fairing, PapersAndStillClayAreLeftAlone) {
  for (const bool paper : {true, false}) {
    Slab slab;
    slab.at({24, 18, 24}) = 1;
    slab.settings.scheme = paper ? Scheme::paper : Scheme::projected;
    if (!paper) {
      slab.moved.clear();
      slab.moved.note(slab.region.index({12, 16, 12}));
    }
    slab.fair(8);
    EXPECT_EQ(slab.at({24, 18, 24}), 1);
    EXPECT_EQ(slab.at({24, 17, 24}), 0);
  }
}

}  // namespace
}  // namespace bozzetto::clay::testing
