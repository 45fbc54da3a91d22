// The stamp: its curve, where it raises clay, what it weighs, and that undo takes it back.
#include "bozzetto/tool/sculpture.hpp"
#include "tool/lowpass.hpp"
#include "tool/tool_fixture.hpp"

namespace bozzetto {
namespace {

using namespace testing;

ActionOptions stampWith(const StampOptions& options = {}, double strength = 1) {
  ActionOptions action{ActionKind::stamp, strength, kToolColour};
  action.stamp = options;
  return action;
}

// A block of clay whose top is the plane y = 0.
template <int Side>
Field<Side> slab(double wide = 40, double deep = 24) {
  Field<Side> field;
  const Primitive box{Shape::box, {0, -deep, 0}, {wide, deep, wide}, {1, 0, 0, 0}, kBallColour};
  fillInto(field, box);
  return field;
}

ToolShape sculpted(const Clay& clay) {
  ToolShape tool;
  tool.shape = Shape::freeform;
  tool.sculpture = std::make_shared<Sculpture>(clay);
  return tool;
}

double trilinearAt(const Clay& clay, const glm::dvec3& place) {
  const glm::dvec3 low = glm::floor(place), t = place - low;
  double sum = 0;
  for (int c = 0; c < 8; ++c) {
    const glm::ivec3 at(c >> 2, c >> 1 & 1, c & 1);
    const glm::dvec3 weight = glm::mix(1.0 - t, t, glm::dvec3(at));
    const glm::ivec3 key = glm::ivec3(low) + at;
    sum += weight.x * weight.y * weight.z * double(clay.value({key.x, key.y, key.z}));
  }
  return sum;
}

// Where the surface is above (x, z), in cells.
double heightAt(const Clay& clay, int x, int z) {
  for (int y = 30; y > -60; --y) {
    const double below = clay.value({x, y, z}), above = clay.value({x, y + 1, z});
    if (below >= 0.5) return y + (below - 0.5) / (below - above);
  }
  return -60;
}

TEST(StampCurve, meetsItsNumbersAndIsSmooth) {
  for (const double iso : {0.3, 0.5, 0.7}) {
    const StampOptions options{.height = 0.4, .rise = 0.2, .fall = 0.35, .slope = 1.1};
    const StampCurve curve(options, iso);
    const double s = 1 - iso;
    EXPECT_EQ(curve(0), -1);
    EXPECT_NEAR(curve(s), 0, 1e-12);
    EXPECT_NEAR(curve(s + 0.2), 0.4, 1e-12);
    EXPECT_NEAR(curve(s + 0.55), 0, 1e-12);
    EXPECT_EQ(curve(s + 0.6), 0);
    const auto slope = [&](double d) { return (curve(d + 1e-6) - curve(d - 1e-6)) / 2e-6; };
    EXPECT_NEAR(slope(s), 1.1, 1e-4);
    EXPECT_NEAR(slope(s + 0.2), 0, 1e-4);
    EXPECT_NEAR(slope(s + 0.55), 0, 1e-4);
    for (double d = 0.01; d < 1.4; d += 0.01) {  // C¹: no jump of value or slope
      EXPECT_NEAR(curve(d), curve(d + 1e-9), 1e-6);
      EXPECT_NEAR(slope(d), slope(d + 1e-5), 3e-3) << d;
    }
  }
}

TEST(StampCurve, bulgesAreTheCurveStretched) {
  const StampOptions options{.height = 0.4, .rise = 0.2, .fall = 0.35, .slope = 1.1};
  const StampCurve curve(options, 0.5);
  std::vector<float> depth, def(400);
  for (int n = 0; n < 400; ++n) depth.push_back(0.01f * static_cast<float>(n));
  for (const double widening : {1.0, 3.0}) {
    curve.bulge(depth.data(), 400, widening, def.data());
    for (std::size_t n = 0; n < depth.size(); ++n) {
      const double beyond = static_cast<double>(depth[n]) - curve.surface();
      const double expected = beyond < 0 ? 0 : curve(curve.surface() + beyond / widening);
      EXPECT_NEAR(def[n], std::max(0.0, expected), 1e-7) << depth[n];
    }
  }
}

TEST(Lowpass, climbsOfFacesAreThoseOfTheWholeNeighbourhood) {
  std::array<CornerBlock<8>, 27> all;
  Neighbourhood<8> near;
  for (std::size_t n = 0; n < 27; ++n) {
    for (std::size_t c = 0; c < 512; ++c)
      all[n].value[c] = static_cast<float>((n * 512 + c) * 7919 % 1009) / 1009.0f;
    near[n] = n == 14 ? nullptr : &all[n];
  }
  LowpassBuffer<8> whole;
  lowpass<8>(near, whole);
  std::array<float, 512> climb;
  const Faces<8> faces{near[13], near[4], near[22], near[10], near[16], near[12], near[14]};
  EXPECT_TRUE(climbOf<8>(faces, climb.data()));
  for (std::size_t n = 0; n < 512; ++n) EXPECT_EQ(climb[n], whole.result.climb[n]) << n;
  EXPECT_FALSE(climbOf<8>({}, climb.data()));
}

TEST(StampCurve, clampsWhatHasNoCurve) {
  const StampOptions wild{.height = -1, .rise = 0, .fall = -3, .slope = 9};
  const StampOptions made = clamped(wild, 0.5);
  EXPECT_EQ(made.height, 0);
  EXPECT_GT(made.rise, 0);
  EXPECT_GT(made.fall, 0);
  EXPECT_EQ(made.slope, 0);
  const StampOptions paper{.rise = 0.6, .fall = 0.9, .profile = StampProfile::paper};
  EXPECT_NEAR(clamped(paper, 0.5).rise + clamped(paper, 0.5).fall, 0.5, 1e-12);
  EXPECT_NEAR(clamped(paper, 0.5).rise, 0.2, 1e-12);
  StampOptions steep{.slope = 100};
  EXPECT_NEAR(clamped(steep, 0.5).slope, 3 * 0.3 / 0.2, 1e-12);
  steep.height = std::nan("");
  EXPECT_THROW(clamped(steep, 0.5), Error);
}

TEST(Stamp, pressesIntoClayAndRaisesARim) {
  for (const Shape shape : {Shape::ellipsoid, Shape::box, Shape::cylinder, Shape::capsule}) {
    Clay clay = slab<8>();
    ToolShape tool = ball(16);
    tool.shape = shape;
    stroke(clay, tool, stampWith(), lineOf({0, 6, 0}, {0, 0, 0}));
    EXPECT_EQ(validate(clay), std::nullopt);
    EXPECT_LT(heightAt(clay, 0, 0), -3) << toText(shape);
    double crest = 0;
    for (int x = 0; x < 39; ++x) crest = std::max(crest, heightAt(clay, x, 0));
    EXPECT_GT(crest, 0.3) << toText(shape);
    EXPECT_NEAR(heightAt(clay, 37, 37), 0, 1e-6) << toText(shape);
  }
}

// The rim's width is what was asked for, in reference radii, for a sculpted tool too.
TEST(Stamp, theRimIsAsWideAsAskedFor) {
  const double radius = 12;
  for (const double rim : {0.5, 1.0}) {
    Clay clay = slab<8>(60);
    StampOptions options;
    options.rise = 0.4 * rim;
    options.fall = 0.6 * rim;
    stroke(clay, sculpted(clayBall<8>(radius)), stampWith(options), dabAt({0, 0, 0}));
    int last = 0;
    for (int x = 0; x < 59; ++x)
      if (heightAt(clay, x, 0) > 0.005) last = x;
    EXPECT_NEAR(last, radius * (1 + rim), 2.5) << rim;
  }
}

TEST(Stamp, raisesNothingInTheAir) {
  Clay clay = clayBall<8>(8, {60, 0, 0});
  const auto before = fieldHash(clay);
  stroke(clay, ball(16), stampWith(), dabAt({0, 0, 0}));
  EXPECT_EQ(fieldHash(clay), before);
  Clay low = slab<8>();
  stroke(low, ball(16), stampWith(), dabAt({0, 4, 0}));
  EXPECT_EQ(low.value({0, 12, 0}), 0);
  EXPECT_EQ(low.value({14, 4, 0}), 0);
}

TEST(Stamp, raisedClayHasTheColourOfItsNeighbours) {
  Clay clay = slab<8>();
  stroke(clay, ball(16), stampWith(), lineOf({0, 6, 0}, {0, 0, 0}));
  for (const auto& [key, sample] : samplesOf(clay))
    EXPECT_EQ(sample.attributes, packAttributes(kBallColour)) << toText(key);
}

// A rim raised by many dabs is as high all round as the clay is round: density added as such gave
// terraces of half a cell.
TEST(Stamp, rimsOfManyDabsHaveNoTerraces) {
  const double radius = 30;
  Clay clay = clayBall<8>(radius);
  const glm::dvec3 way = glm::normalize(glm::dvec3(1, 2, 4));
  const glm::dvec3 side = glm::normalize(glm::cross(way, glm::dvec3(0, 0, 1)));
  StampOptions options{.height = 0.5, .rise = 0.25, .fall = 0.5};
  stroke(clay, ball(16), stampWith(options), lineOf(38.0 * way, 28.0 * way));
  const auto surfaceAlong = [&](const glm::dvec3& to) {
    double inside = 0.5 * radius, outside = 2 * radius;
    for (int n = 0; n < 40; ++n) {
      const double middle = 0.5 * (inside + outside);
      (trilinearAt(clay, middle * to) >= 0.5 ? inside : outside) = middle;
    }
    return inside;
  };
  double low = 1e9, high = 0;
  for (int n = 0; n < 90; ++n) {
    const double turn = 6.2831853 * n / 90, lean = 0.42;
    const glm::dvec3 across = std::cos(turn) * side + std::sin(turn) * glm::cross(way, side);
    const double at = surfaceAlong(std::cos(lean) * way + std::sin(lean) * across);
    low = std::min(low, at);
    high = std::max(high, at);
  }
  EXPECT_GT(low, radius + 1);
  EXPECT_LT(high - low, 0.35);
}

TEST(Stamp, undoGivesTheBytesBack) {
  for (const bool conserving : {false, true}) {
    Clay clay = slab<8>();
    const auto before = fieldHash(clay);
    StampOptions options;
    options.conserving = conserving;
    const auto made = stroke(clay, ball(14), stampWith(options), lineOf({-9, 2, 0}, {9, 2, 3}));
    EXPECT_NE(fieldHash(clay), before);
    made.delta.apply(clay.tree, Direction::backward);
    EXPECT_EQ(fieldHash(clay), before);
  }
}

TEST(Stamp, symmetricToolsLeaveSymmetricPrints) {
  Clay clay = slab<8>();
  Clay source = clayBall<8>(6);
  fillInto(source, ballOf(3, {8, 0, 0}));
  fillInto(source, ballOf(3, {-8, 0, 0}));
  stroke(clay, sculpted(source), stampWith(), dabAt({0, 0, 0}));
  const auto samples = samplesOf(clay);
  for (const auto& [key, sample] : samples) {
    const auto twin = samples.find({-key.i, key.j, key.k});
    ASSERT_NE(twin, samples.end());
    EXPECT_NEAR(twin->second.value, sample.value, 1e-4) << toText(key);
  }
}

// However often it is pressed, a sculpture's print has the sculpture's wall.
TEST(Stamp, sculpturesPressNoFurtherThanTheyAre) {
  const ToolShape tool = sculpted(clayBall<8>(7));
  const glm::dvec3 at(0.3, -3.4, 0.7);
  Clay there;
  ActionOptions add{ActionKind::add, 1, kToolColour};
  stroke(there, tool, add, dabAt(at));
  StampOptions flat;
  flat.height = 0;
  Clay clay = slab<8>();
  const Clay before = clay;
  for (int n = 0; n < 40; ++n) stroke(clay, tool, stampWith(flat, 0.6), dabAt(at));
  for (const auto& [key, sample] : samplesOf(before)) {
    const float wall = std::min(sample.value, 1 - there.value(key));
    if (there.value(key) > 0.02f) {
      ASSERT_NEAR(clay.value(key), wall, 1e-6) << toText(key);
    }
  }
  StampOptions conserving;
  conserving.conserving = true;
  clay = before;
  stroke(clay, tool, stampWith(conserving), dabAt(at));
  EXPECT_NEAR(clay.value({7, -3, 1}), 1 - there.value({7, -3, 1}), 1e-6);
}

double massOf(const Clay& clay) { return double(massUnits(clay)) * kMassUnit; }

TEST(Stamp, conservingStampsConserve) {
  for (const double radius : {6.0, 14.0}) {
    for (const bool freeform : {false, true}) {
      Clay clay = slab<8>(60, 30);
      const double before = massOf(clay);
      StampOptions options;
      options.conserving = true;
      const ToolShape tool = freeform ? sculpted(clayBall<8>(radius / 2)) : ball(radius);
      stroke(clay, tool, stampWith(options), lineOf({0, 5, 0}, {1, 0.5, 0}));
      EXPECT_LT(heightAt(clay, 1, 0), -1);
      EXPECT_NEAR(massOf(clay) / before, 1, 1e-9) << radius << freeform;
      EXPECT_EQ(validate(clay), std::nullopt);
    }
  }
}

TEST(Stamp, conservingAndPlainDifferInMassOnly) {
  Clay plain = slab<8>(60, 30), conserved = plain;
  StampOptions options;
  stroke(plain, ball(14), stampWith(options), dabAt({0, 0, 0}));
  options.conserving = true;
  stroke(conserved, ball(14), stampWith(options), dabAt({0, 0, 0}));
  EXPECT_LT(massOf(plain), massOf(conserved));
  for (int y = -12; y < 0; ++y)
    EXPECT_EQ(plain.value({0, y, 0}), conserved.value({0, y, 0}));  // the print is the same
}

TEST(Stamp, pressedThroughAThinPlateWhatFindsNoRoomIsMissing) {
  Clay crumb = clayBall<8>(2);
  StampOptions options;
  options.conserving = true;
  stroke(crumb, ball(20), stampWith(options), dabAt({0, 0, 0}));
  EXPECT_LT(massOf(crumb), 30);
}

TEST(Stamp, sidesAndInstructionSetsAgreeToTheBit) {
  const auto session = [&]<int Side>() {
    Field<Side> field = slab<Side>(26, 12);
    StampOptions options;
    const ToolShape tools[] = {ball(9), oblique(Shape::box), oblique(Shape::capsule),
                               sculpted(clayBall<8>(5.3, {1, 2, 0}))};
    for (int n = 0; n < 8; ++n) {
      options.conserving = n == 5 || n == 7;
      options.profile = n == 2 ? StampProfile::paper : StampProfile::radius;
      stroke(field, tools[n % 4], stampWith(options, 0.8),
             lineOf({4.0 * n - 14, 2, -5}, {4.0 * n - 12, 1, 4}));
    }
    EXPECT_EQ(validate(field), std::nullopt);
    return fieldHash(field);
  };
  expectSameBits(session);
}

}  // namespace
}  // namespace bozzetto
