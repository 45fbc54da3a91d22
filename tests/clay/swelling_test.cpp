// Relief that grows: on thick clay, on sheets that have little to give, and in the form of tools
// that are sculptures.
#include "bozzetto/tool/sculpture.hpp"
#include "clay/clay_fixture.hpp"

namespace bozzetto::clay::testing {
namespace {

// Notices are the stroke's, once finished.
std::string swell(Clay& clay, const ToolShape& tool, std::vector<glm::dvec3> points) {
  Stroke stroke;
  for (const glm::dvec3& point : points) stroke.points.push_back({point, 1});
  Edit<CornerBlock<8>> edit(clay.tree);
  ClayStroke<8> swelling(edit, clay.scale, tool, {Role::swell, 1}, stroke, {});
  for (std::int64_t step = 0; step < swelling.stepCount(); ++step) swelling.step(step);
  swelling.finish();
  swelling.store();
  edit.commit();
  return swelling.notice();
}

double heightAt(const Clay& clay, int i, int k, int from) {
  double height = 0;
  for (int j = from; j < 24; ++j)
    height += static_cast<double>(std::min(1.0f, clay.value({i, j, k})));
  return height;
}

// Cells with clay in front and behind along y, and too little themselves.
int hollows(const Clay& clay, int half) {
  int count = 0;
  for (int i = -half; i <= half; ++i)
    for (int k = -half; k <= half; ++k) {
      bool clayBelow = false;
      int open = 0;
      for (int j = -24; j < 24; ++j) {
        const bool isClay = clay.value({i, j, k}) >= 0.5f;
        if (isClay && clayBelow) count += open;
        if (isClay)
          clayBelow = true, open = 0;
        else
          ++open;
      }
    }
  return count;
}

class Sheet : public ::testing::TestWithParam<double> {};

// Thicker where the brush was, by what the clay round it can spare; whole, without a hollow, and
// its other side where it was.
TEST_P(Sheet, SlowSwellsWithoutTearing) {
  const double half = GetParam() / 2;
  for (const double radius : {5.0, 9.0, 16.0}) {
    Clay clay;
    addSolid(clay, Shape::box, {0, 0, 0}, {30, half, 30});
    const Measures before = measure(clay);
    for (int n = 0; n < 3; ++n)
      swell(clay, toolOf(Shape::ellipsoid, {radius, radius, radius}),
            {{-8, half, 0}, {8, half, 0}});
    const Measures after = measure(clay);
    EXPECT_NEAR(after.mass / before.mass, 1, 1e-7) << radius;
    EXPECT_EQ(after.pieces, 1) << radius;
    EXPECT_EQ(hollows(clay, 34), 0) << radius;
    EXPECT_GT(heightAt(clay, 0, 0, 0), half + 0.5) << radius;
    EXPECT_LT(clay.value({0, static_cast<int>(-half) - 2, 0}), 0.1f) << radius;
  }
}

INSTANTIATE_TEST_SUITE_P(Swelling, Sheet, ::testing::Values(4, 5, 6));

TEST(Swelling, SaysWhereClayHasNothingToGive) {
  Clay thin, thick;
  addSolid(thin, Shape::box, {0, 0, 0}, {20, 1.5, 20});
  addSolid(thick, Shape::box, {0, -12, 0}, {20, 12, 20});
  const ToolShape tool = toolOf(Shape::ellipsoid, {6, 6, 6});
  const std::uint64_t before = fieldHash(thin);
  EXPECT_EQ(swell(thin, tool, {{-4, 1.5, 0}, {4, 1.5, 0}}),
            "swell: there is too little clay round the tool to draw from");
  EXPECT_EQ(fieldHash(thin), before);
  EXPECT_EQ(swell(thick, tool, {{-4, 0, 0}, {4, 0, 0}}), "");
}

ToolShape sculpted(const Clay& clay, const SculptureOptions& options = {}) {
  ToolShape tool;
  tool.shape = Shape::freeform;
  tool.sculpture = std::make_shared<Sculpture>(clay, options);
  tool.radii = tool.sculpture->halfExtents();
  return tool;
}

// A star of thin arms, four cells across, on a middle of twelve.
Clay star() {
  Clay clay;
  addSolid(clay, Shape::ellipsoid, {0, 0, 0}, {6, 6, 6});
  addSolid(clay, Shape::box, {0, 0, 0}, {16, 2, 2});
  addSolid(clay, Shape::box, {0, 0, 0}, {2, 2, 16});
  return clay;
}

TEST(Swelling, ASculptedBallRaisesWhatABallDoes) {
  Clay ball, one, other;
  addSolid(ball, Shape::ellipsoid, {0, 0, 0}, {7, 7, 7});
  for (Clay* clay : {&one, &other}) addSolid(*clay, Shape::box, {0, -10, 0}, {20, 10, 20});
  swell(one, toolOf(Shape::ellipsoid, {7, 7, 7}), {{-6, 0, 0}, {6, 0, 0}});
  swell(other, sculpted(ball), {{-6, 0, 0}, {6, 0, 0}});
  EXPECT_NEAR(heightAt(other, 0, 0, 0), heightAt(one, 0, 0, 0), 0.6);
}

// Whether it stands in the clay or, on its pivot, on it.
TEST(Swelling, ReliefHasTheFormOfASculptedTool) {
  for (const double pivot : {0.0, -6.0}) {
    Clay clay;
    addSolid(clay, Shape::box, {0, -14, 0}, {26, 14, 26});
    const ToolShape tool = sculpted(star(), {.pivot = glm::dvec3(0, pivot, 0)});
    for (int n = 0; n < 8; ++n) swell(clay, tool, {{0, 0, 0}, {0, 0.5, 0}});
    const double flat = 0.5;
    EXPECT_GT(heightAt(clay, 11, 0, 0), flat + 0.6) << pivot;  // an arm
    EXPECT_GT(heightAt(clay, 0, 11, 0), flat + 0.6) << pivot;
    EXPECT_LT(heightAt(clay, 9, 9, 0), flat + 0.1) << pivot;  // between
    EXPECT_EQ(measure(clay).pieces, 1) << pivot;
  }
}

}  // namespace
}  // namespace bozzetto::clay::testing
