// Actions against plain loops written from the formulas (algorithms.md §1), in double.
#include "tool/tool_fixture.hpp"

namespace bozzetto {
namespace {

using namespace testing;

constexpr double kStrength = 0.4;
const glm::dvec3 kAt(5.25, -2.5, 1.75);
constexpr double kRadius = 7;

double potentialAt(Key corner) {
  return wyvill(glm::length(glm::dvec3(corner.i, corner.j, corner.k) - kAt) / kRadius);
}

Sample at(const Samples& samples, Key key) {
  const auto found = samples.find(key);
  return found == samples.end() ? Sample{} : found->second;
}

// Clay of two colours, some of it held.
Clay groundClay() {
  Clay clay = clayBall<8>(8);
  fillInto(clay, ballOf(5, {6, 0, 0}, Colour{10, 250, 30}));
  Edit<CornerBlock<8>> edit(clay.tree);
  for (int n = 0; n < 8; ++n) {
    auto& block = edit.write({0, 0, 0});
    const int place = BlockGeometry<8>::indexOf(Key{n, 1, 1});
    if (block.value[place] > 0)
      block.attributes[place] |= static_cast<Attributes>(n == 7 ? 255 : 36 * n) << 24;
  }
  edit.commit();
  return clay;
}

struct Expected {
  double value;
  double colour[3];
};
using Rule = std::function<Expected(const Sample& old, double p, double free, Key corner)>;

// Compares the action with a rule at every corner near the tool.
void expectRule(ActionKind kind, const Rule& rule) {
  Clay clay = groundClay();
  const Samples before = samplesOf(clay);
  stroke(clay, ball(kRadius), {kind, kStrength, kToolColour}, dabAt(kAt));
  EXPECT_EQ(validate(clay), std::nullopt);
  const Samples after = samplesOf(clay);
  for (int i = -12; i <= 14; ++i)
    for (int j = -12; j <= 12; ++j)
      for (int k = -12; k <= 12; ++k) {
        const Key key{i, j, k};
        const Sample old = at(before, key), now = at(after, key);
        const double p = potentialAt(key), free = 1 - holdOf(old.attributes) / 255.0;
        if (p == 0 || free == 0) {
          ASSERT_EQ(now.value, old.value) << toText(key);
          ASSERT_EQ(now.attributes, old.attributes) << toText(key);
          continue;
        }
        const Expected expected = rule(old, p, free, key);
        ASSERT_NEAR(now.value, expected.value, 2e-6) << toText(key);
        if (now.value < 1e-6) continue;
        ASSERT_EQ(holdOf(now.attributes), holdOf(old.attributes)) << toText(key);
        const Colour colour = colourOf(now.attributes);
        const double channel[3] = {double(colour.r), double(colour.g), double(colour.b)};
        for (int c = 0; c < 3; ++c)
          ASSERT_NEAR(channel[c], expected.colour[c], 0.502) << toText(key) << " channel " << c;
      }
}

Expected keep(const Sample& old, double value) {
  const Colour c = colourOf(old.attributes);
  return {value, {double(c.r), double(c.g), double(c.b)}};
}

// Mixed by t and rounded; at least one step where amount > 1/64.
Expected mix(const Sample& old, double value, double t, double amount) {
  Expected made = keep(old, value);
  const double tool[3] = {double(kToolColour.r), double(kToolColour.g), double(kToolColour.b)};
  for (int c = 0; c < 3; ++c) {
    const double from = made.colour[c], exact = from + t * (tool[c] - from);
    const bool stalls = std::abs(exact - from) < 0.5 && amount > 1.0 / 64 && tool[c] != from;
    made.colour[c] = stalls ? from + (tool[c] > from ? 1 : -1) : exact;
  }
  return made;
}

TEST(Action, addIsTheFormula) {
  expectRule(ActionKind::add, [](const Sample& old, double p, double free, Key) {
    const double amount = kStrength * p * free;
    return mix(old, std::min(1.0, old.value + amount), amount / (old.value + amount), amount);
  });
}

TEST(Action, removeIsTheFormula) {
  expectRule(ActionKind::remove, [](const Sample& old, double p, double free, Key) {
    return keep(old, std::max(0.0, old.value - kStrength * p * free));
  });
}

TEST(Action, eraseDeletes) {
  expectRule(ActionKind::erase, [](const Sample& old, double, double, Key) {
    return keep(old, holdOf(old.attributes) < 128 ? 0 : old.value);
  });
}

TEST(Action, paintGivesTheColour) {
  expectRule(ActionKind::paint, [](const Sample& old, double, double, Key) {
    return holdOf(old.attributes) < 128 ? mix(old, old.value, 1, 1) : keep(old, old.value);
  });
}

TEST(Action, paintSoftIsTheFormula) {
  expectRule(ActionKind::paintSoft, [](const Sample& old, double p, double free, Key) {
    const double amount = kStrength * p * free;
    return mix(old, old.value, old.value > 0 ? amount / (amount + old.value) : 0, amount);
  });
}

TEST(Action, smoothIsTheBinomialOfTheOldValues) {
  const Samples ground = samplesOf(groundClay());
  expectRule(ActionKind::smooth, [&](const Sample& old, double p, double free, Key key) {
    double low = 0, colour[3] = {};
    for (int n = 0; n < 27; ++n) {
      const Key d{n / 9 - 1, n / 3 % 3 - 1, n % 3 - 1};
      const double weight = (2 - std::abs(d.i)) * (2 - std::abs(d.j)) * (2 - std::abs(d.k)) / 64.0;
      const Sample near = at(ground, key + d);
      const Colour c = colourOf(near.attributes);
      low += weight * near.value;
      colour[0] += weight * near.value * c.r;
      colour[1] += weight * near.value * c.g;
      colour[2] += weight * near.value * c.b;
    }
    const double amount = kStrength * p * free;
    const double value = old.value + amount * (low - old.value);
    Expected made = keep(old, value < 1e-4 ? 0 : value);
    for (int c = 0; c < 3; ++c) {
      made.colour[c] =
          ((1 - amount) * old.value * made.colour[c] + amount * colour[c]) / std::max(value, 1e-9);
    }
    return made;
  });
}

TEST(Action, addOnNothingIsThePotential) {
  Clay clay;
  stroke(clay, ball(kRadius), {ActionKind::add, 1, kToolColour}, dabAt(kAt));
  for (const auto& [key, sample] : samplesOf(clay)) {
    ASSERT_NEAR(sample.value, potentialAt(key), 1e-6);
    ASSERT_EQ(sample.attributes, packAttributes(kToolColour));
  }
  EXPECT_GT(statistics(clay).mass, 0);
  EXPECT_EQ(validate(clay), std::nullopt);
}

TEST(Action, paintsNeverChangeValues) {
  for (const ActionKind kind : {ActionKind::paint, ActionKind::paintSoft}) {
    Clay clay = clayBall<8>(10);
    const auto mass = massUnits(clay);
    const auto corners = statistics(clay).corners;
    stroke(clay, ball(9), {kind, 0.7, kToolColour}, lineOf({-9, 0, 0}, {9, 6, 0}));
    EXPECT_TRUE(massUnits(clay) == mass);
    EXPECT_EQ(statistics(clay).corners, corners);
  }
}

TEST(Action, slowPaintingNeverStalls) {
  Clay clay = clayBall<8>(6);
  for (int n = 0; n < 260; ++n)
    stroke(clay, ball(4), {ActionKind::paintSoft, 0.05, kToolColour}, dabAt({0, 0, 0}));
  EXPECT_EQ(clay.attributes({0, 0, 0}), packAttributes(kToolColour));
}

TEST(Action, smoothKeepsConstantClay) {
  Clay clay = clayBall<8>(24);
  const auto hash = fieldHash(clay);
  const auto made = stroke(clay, ball(12), {ActionKind::smooth, 1, {}}, dabAt({1, 2, 3}));
  EXPECT_TRUE(made.delta.empty());
  EXPECT_EQ(made.report.total.dirty, 0);
  EXPECT_EQ(fieldHash(clay), hash);
}

TEST(Action, smoothConservesMassUpToWhatItDrops) {
  Clay clay = clayBall<8>(9);
  const auto before = massUnits(clay);
  ToolShape tool = ball(30);  // the whole of the clay is inside its flat part
  tool.profile = Profile::box;
  MassUnits dropped = 0;
  for (int n = 0; n < 6; ++n)
    dropped += stroke(clay, tool, {ActionKind::smooth, 0.7, {}}, dabAt({})).report.total.dropped;
  EXPECT_GT(dropped, 0);
  const auto lost = static_cast<double>(before - massUnits(clay) - dropped);
  EXPECT_LT(std::abs(lost) / static_cast<double>(before), 1e-8);
}

TEST(Action, eraseLeavesNothingBehind) {
  Clay clay = clayBall<8>(9);
  const auto made = stroke(clay, ball(30), {ActionKind::erase, 0.1, {}}, dabAt({0, 0, 0}));
  EXPECT_TRUE(clay.tree.empty());
  EXPECT_FALSE(made.delta.empty());
}

TEST(Action, heldClayStays) {
  for (int kind = 0; kind < 6; ++kind) {
    Clay clay = clayBall<8>(9);
    Edit<CornerBlock<8>> edit(clay.tree);
    for (const auto& [key, sample] : samplesOf(clay)) {
      auto& block = edit.write(BlockGeometry<8>::blockOf(key));
      block.attributes[BlockGeometry<8>::indexOf(key)] |= 0xff000000u;
    }
    edit.commit();
    const Samples before = samplesOf(clay);
    stroke(clay, ball(12), {static_cast<ActionKind>(kind), 0.8, kToolColour}, dabAt({4, 0, 0}));
    const Samples after = samplesOf(clay);
    for (const auto& [key, sample] : before) {
      ASSERT_EQ(at(after, key).value, sample.value) << kind;
      ASSERT_EQ(at(after, key).attributes, sample.attributes) << kind;
    }
  }
}

}  // namespace
}  // namespace bozzetto
