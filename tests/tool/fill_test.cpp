// Fill: values from true distances, the rule of the greater value, a cheap inside.
#include "bozzetto/base/parallel.hpp"
#include "tool/tool_fixture.hpp"

namespace bozzetto {
namespace {

using namespace testing;

using Surface = std::function<bool(glm::dvec3)>;  // inside?

// Distance to an ellipsoid by bisection in double, from Eberly's equation.
double ellipsoidDistance(glm::dvec3 r, glm::dvec3 p) {
  p = glm::abs(p) + 1e-9;
  const auto sum = [&](double t) {
    double s = 0;
    for (int a = 0; a < 3; ++a) s += std::pow(r[a] * p[a] / (t + r[a] * r[a]), 2);
    return s;
  };
  const double least = std::min({r.x, r.y, r.z});
  double low = -least * least, high = glm::length(p) * std::max({r.x, r.y, r.z}) * 2;
  for (int n = 0; n < 70; ++n) (sum((low + high) / 2) > 1 ? low : high) = (low + high) / 2;
  glm::dvec3 nearest;
  for (int a = 0; a < 3; ++a) nearest[a] = r[a] * r[a] * p[a] / (low + r[a] * r[a]);
  return glm::length(p - nearest) * (sum(0) > 1 ? 1 : -1);
}

double boxDistance(glm::dvec3 r, glm::dvec3 p) {
  const glm::dvec3 q = glm::abs(p) - r;
  return glm::length(glm::max(q, 0.0)) + std::min(0.0, std::max({q.x, q.y, q.z}));
}

double distanceTo(const Primitive& primitive, glm::dvec3 world) {
  const glm::dvec3 r = primitive.radii;
  const glm::dvec3 p =
      glm::inverse(glm::normalize(primitive.rotation)) * (world - primitive.centre);
  if (primitive.shape == Shape::box) return boxDistance(r, p);
  if (primitive.shape == Shape::ellipsoid) return ellipsoidDistance(r, p);
  if (primitive.shape == Shape::cylinder) {
    const double across = ellipsoidDistance({r.x, 1e4, r.z}, {p.x, 0, p.z});
    const double along = std::abs(p.y) - r.y;
    return std::hypot(std::max(across, 0.0), std::max(along, 0.0)) +
           std::min(0.0, std::max(across, along));
  }
  const double cap = std::min(r.y, std::sqrt(r.x * r.z));
  return ellipsoidDistance({r.x, cap, r.z}, {p.x, std::max(0.0, std::abs(p.y) - r.y + cap), p.z});
}

// |error of distance| < 0.05 cell where the value is strictly between 0 and 1.
void expectDistances(const Primitive& primitive, int reach) {
  Clay clay;
  fillInto(clay, primitive);
  ASSERT_EQ(validate(clay), std::nullopt);
  for (int i = -reach; i <= reach; ++i)
    for (int j = -reach; j <= reach; ++j)
      for (int k = -reach; k <= reach; ++k) {
        const double distance = distanceTo(primitive, {i, j, k});
        const double expected = std::clamp(0.5 - distance / 2, 0.0, 1.0);
        ASSERT_NEAR(clay.value({i, j, k}), expected, 0.025)
            << toText(primitive.shape) << toText(Key{i, j, k}) << " distance " << distance;
      }
}

TEST(Fill, valuesAreTrueDistances) {
  for (int n = 0; n < 4; ++n) {
    for (const glm::dvec3 radii : {glm::dvec3{9, 6.5, 14.2}, {5, 5, 5}, {16, 4, 2.5}, {7, 12, 7}}) {
      const Primitive primitive{
          static_cast<Shape>(n), {0.3, -0.7, 0.1}, radii, {0.7, 0.2, -0.5, 0.3}, {}};
      expectDistances(primitive, 20);
    }
  }
}

TEST(Fill, largeEllipsoidsToo) {
  Clay clay;
  const Primitive primitive{Shape::ellipsoid, {}, {300, 140, 60}, {0.7, 0.2, -0.5, 0.3}, {}};
  fillInto(clay, primitive);
  int looked = 0;
  for (const auto& [key, run] : clay.tree) {
    if (run.block->interned || ++looked % 97 != 0) continue;
    for (int n = 0; n < 512; n += 7) {
      const Key corner = key * 8 + Key{n / 64, n / 8 % 8, n % 8};
      const double distance = distanceTo(primitive, {corner.i, corner.j, corner.k});
      ASSERT_NEAR(run.block->value[n], std::clamp(0.5 - distance / 2, 0.0, 1.0), 0.025);
    }
  }
  EXPECT_GT(looked, 1000);
}

TEST(Fill, keepsTheGreaterValueAndItsColour) {
  Clay clay = clayBall<8>(20, {0, 0, 0}, kBallColour);
  const Clay other = clayBall<8>(20, {13, 5, 0}, kToolColour);
  const Clay before = clay;
  fillInto(clay, ballOf(20, {13, 5, 0}, kToolColour));
  EXPECT_EQ(validate(clay), std::nullopt);
  for (const auto& [key, sample] : samplesOf(clay)) {
    const float a = before.value(key), b = other.value(key);
    ASSERT_EQ(sample.value, std::max(a, b));
    ASSERT_EQ(colourOf(sample.attributes), b > a ? kToolColour : kBallColour);
  }
}

TEST(Fill, raisesUniformClayBelowFull) {
  Clay clay;
  Edit<CornerBlock<8>> edit(clay.tree);
  edit.replace({{-2, 0, -3}, 6}, CornerBlock<8>::uniform(0.25f, packAttributes(kBallColour)));
  edit.commit();
  fillInto(clay, ballOf(30, {}, kToolColour));
  EXPECT_EQ(clay.value({-12, 3, -18}), 1.0f);
  EXPECT_EQ(validate(clay), std::nullopt);
  EXPECT_EQ(fieldHash(clay), fieldHash(clayBall<8>(30, {}, kToolColour)));
}

TEST(Fill, fillingTwiceChangesNothing) {
  Clay clay = clayBall<8>(33);
  EXPECT_TRUE(fillInto(clay, ballOf(33, {}, kToolColour)).empty());
}

TEST(Fill, theInsideCostsNoCornerStorage) {
  const FieldStatistics small = statistics(clayBall<8>(60)), large = statistics(clayBall<8>(240));
  EXPECT_LT(large.blocks, 18 * small.blocks);  // as the surface: 16 times, not 64
  EXPECT_LT(large.nodes, 18 * small.nodes);
  const double volume = 4.0 / 3 * 3.14159265 * 240 * 240 * 240;
  EXPECT_NEAR(large.mass, volume, 1e-4 * volume);
}

TEST(Fill, spacingScalesWorldUnits) {
  Clay coarse = clayBall<8>(16);
  Clay fine;
  fine.scale.spacing = 0.25;
  fillInto(fine, ballOf(4));
  EXPECT_EQ(fieldHash(coarse), fieldHash(fine));
}

TEST(Fill, threadsDoNotShow) {
  setThreadCount(1);
  const auto one = fieldHash(clayBall<8>(90, {0.5, 3.25, 7}));
  setThreadCount(3);
  EXPECT_EQ(fieldHash(clayBall<8>(90, {0.5, 3.25, 7})), one);
  setThreadCount(0);
}

TEST(Fill, quarterTurnIsSwappedRadii) {
  for (const Shape shape : {Shape::ellipsoid, Shape::box}) {
    Clay turned, swapped;
    const double half = std::sqrt(0.5);
    fillInto(turned, {shape, {1, 2, 3}, {12, 7, 9}, {half, 0, 0, half}, {}});
    fillInto(swapped, {shape, {1, 2, 3}, {7, 12, 9}, {1, 0, 0, 0}, {}});
    EXPECT_EQ(fieldHash(turned), fieldHash(swapped));
  }
}

TEST(Fill, refusesBadPrimitives) {
  const double nan = std::nan(""), infinite = HUGE_VAL;
  const auto refuses = [](const Primitive& primitive) {
    Clay clay;
    EXPECT_THROW(fillInto(clay, primitive), Error);
    EXPECT_TRUE(clay.tree.empty());
  };
  for (const double bad : {0.0, -1.0, nan, infinite, 1e7, 1e300})
    refuses({Shape::ellipsoid, {}, {bad, 5, bad}, {1, 0, 0, 0}, {}});
  for (const double bad : {nan, infinite, 2e9, 0x1p30}) refuses(ballOf(5, {0, bad, 0}));
  refuses({Shape::box, {}, {5, 5, 5}, {0, 0, 0, 0}, {}});
  refuses({Shape::box, {}, {5, 5, 5}, {nan, 0, 0, 1}, {}});
}

struct StopAt : Progress {
  double limit;
  explicit StopAt(double at) : limit(at) {}
  bool report(std::string_view, double done) override { return done < limit; }
};

TEST(Fill, cancellingLeavesTheClayAlone) {
  Clay clay = clayBall<8>(20);
  const auto hash = fieldHash(clay);
  Edit<CornerBlock<8>> edit(clay.tree);
  StopAt half(0.5);
  EXPECT_THROW(fill<8>(edit, clay.scale, ballOf(50, {20, 0, 0}), half), Cancelled);
  EXPECT_TRUE(edit.commit().empty());
  EXPECT_EQ(fieldHash(clay), hash);
}

}  // namespace
}  // namespace bozzetto
