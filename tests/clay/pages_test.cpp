// Memory that strokes leave to each other: zeros, whatever was written.
#include "clay/pages.hpp"

#include <cstring>

#include "clay/clay_fixture.hpp"

namespace bozzetto::clay::testing {
namespace {

constexpr std::size_t kSome = 3 << 20;

bool isAllZero(const Pages& pages) {
  const auto* bytes = static_cast<const unsigned char*>(pages.data);
  for (std::size_t n = 0; n < pages.bytes; ++n)
    if (bytes[n] != 0) return false;
  return true;
}

TEST(Pages, ComeBackAsZeros) {
  for (const std::size_t first : {std::size_t{0}, kSome / 2, kSome - 1}) {
    const Pages pages = takePages(kSome);
    ASSERT_GE(pages.bytes, kSome);
    EXPECT_TRUE(isAllZero(pages));
    std::memset(static_cast<char*>(pages.data) + first, 7, kSome - first);
    givePagesBack(pages);
  }
  const Pages again = takePages(kSome);
  EXPECT_TRUE(isAllZero(again));
  givePagesBack(again);
}

TEST(Pages, OfAFinishedStrokeServeTheNext) {
  const Pages pages = takePages(kSome);
  std::memset(pages.data, 7, kSome);
  givePagesBack(pages);
  const Pages again = takePages(kSome);
  EXPECT_EQ(again.data, pages.data);
  givePagesBack(again);
}

// What is too much to keep is the system's again, and comes as zeros too.
TEST(Pages, LargeOnesComeAsZerosToo) {
  constexpr std::size_t large = 40u << 20;
  for (int n = 0; n < 2; ++n) {
    const Pages pages = takePages(large);
    EXPECT_EQ(static_cast<char*>(pages.data)[large / 2], 0);
    std::memset(pages.data, 7, large);
    givePagesBack(pages);
  }
}

// A stroke does not see what strokes before it left behind, whatever layers they ran.
TEST(Pages, StrokesLeaveNothingToTheNext) {
  const auto pressed = [](std::vector<LayerKind> layers, double radius) {
    Clay clay;
    addSolid(clay, Shape::box, {0, -12, 0}, {20, 12, 20}, {200, 90, 60});
    addSolid(clay, Shape::ellipsoid, {6, 0, 6}, {6, 6, 6}, {60, 90, 200});
    Push push;
    push.tool = toolOf(Shape::ellipsoid, glm::dvec3(radius));
    push.setup.settings.layers = std::move(layers);
    push.setup.settings.stiffness = 0.05;
    push.stroke.points = {{{0, radius, 0}, 1}, {{0, radius - 4, 2}, 1}};
    run(clay, push);
    return fieldHash(clay);
  };
  const std::vector<LayerKind> all{LayerKind::displacement, LayerKind::conservation,
                                   LayerKind::tension};
  const std::vector<std::vector<LayerKind>> ways{
      all, {LayerKind::diffusion}, {LayerKind::automaton, LayerKind::tension}};
  std::vector<std::uint64_t> first;
  for (const auto& layers : ways) first.push_back(pressed(layers, 6));
  for (const auto& layers : ways) pressed(layers, 7.5);
  for (std::size_t n = ways.size(); n-- > 0;) EXPECT_EQ(pressed(ways[n], 6), first[n]) << n;
}

}  // namespace
}  // namespace bozzetto::clay::testing
