// Undo and redo of what people do: strokes of all kinds, mirrored ones too.
#include <gtest/gtest.h>

#include <random>

#include "bozzetto/field/difference.hpp"
#include "bozzetto/sculptor/sculptor.hpp"

namespace bozzetto {
namespace {

class RandomStrokes {
 public:
  explicit RandomStrokes(unsigned seed) : random_(seed) {}

  void prepare(Sculptor& sculptor) {
    constexpr ActionKind kKinds[] = {ActionKind::add,    ActionKind::add,      ActionKind::remove,
                                     ActionKind::smooth, ActionKind::erase,    ActionKind::paint,
                                     ActionKind::stamp,  ActionKind::paintSoft};
    ActionOperation action;
    action.action.kind = kKinds[pick(std::size(kKinds))];
    action.action.colour = {static_cast<std::uint8_t>(pick(256)), 90, 40};
    sculptor.apply(action);
    ToolOperation tool;
    tool.shape.radii = {2 + pick(3), 2 + pick(3), 2 + pick(3)};
    sculptor.apply(tool);
  }

  StrokeOperation stroke() {
    StrokeOperation stroke;
    const glm::dvec3 first(pick(40) - 20, pick(40) - 20, pick(40) - 20);
    stroke.stroke.points = {{first}, {first + glm::dvec3(pick(5) - 2, pick(5) - 2, pick(5) - 2)}};
    stroke.stroke.spacing = 0.5;
    stroke.stroke.symmetry.mirror[0] = pick(3) == 0;
    return stroke;
  }

 private:
  int pick(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  std::mt19937 random_;
};

// In a memory that holds a few hundred of them; the others are packed.
TEST(Undo, SlowTenThousandRandomStrokesThereAndBack) {
  HistoryLimits limits;
  limits.memoryBytes = 64u << 20;
  Sculptor sculptor({}, History<8>(limits), SurfaceUpkeep::none);
  RandomStrokes strokes(11);
  constexpr int kStrokes = 10'000, kEvery = 500;
  std::vector<std::uint64_t> hashes{fieldHash(sculptor.field())};
  for (int n = 1; n <= kStrokes; ++n) {
    if (n % 10 == 1) strokes.prepare(sculptor);
    sculptor.apply(strokes.stroke());
    if (n % kEvery == 0) hashes.push_back(fieldHash(sculptor.field()));
  }
  ASSERT_EQ(sculptor.history().undoDepth(), std::size_t{kStrokes});
  for (std::size_t n = hashes.size() - 1; n-- > 0;) {
    sculptor.apply(UndoOperation{kEvery});
    ASSERT_EQ(fieldHash(sculptor.field()), hashes[n]) << n;
  }
  EXPECT_TRUE(sculptor.field().tree.empty());
  for (std::size_t n = 1; n < hashes.size(); ++n) {
    sculptor.apply(RedoOperation{kEvery});
    ASSERT_EQ(fieldHash(sculptor.field()), hashes[n]) << n;
  }
  EXPECT_EQ(validate(sculptor.field()), std::nullopt);
}

TEST(Undo, AMirroredStrokeIsOneStepAndTouchesNothingElse) {
  Sculptor sculptor;
  FillOperation body;
  body.primitive.radii = {30, 12, 12};
  sculptor.apply(body);
  const Clay before = sculptor.field();
  ToolOperation tool;
  tool.shape.radii = {4, 4, 4};
  sculptor.apply(tool);
  StrokeOperation stroke;
  stroke.stroke.points = {{{25, 8, 0}}, {{20, 8, 0}}};
  stroke.stroke.symmetry.mirror[0] = true;
  sculptor.apply(stroke);
  EXPECT_EQ(sculptor.history().steps().size(), 2u);
  const FieldDifference done = compare(before, sculptor.field());
  EXPECT_EQ(done.bounds.low.i, -done.bounds.high.i);
  const OperationReport undone = sculptor.apply(UndoOperation{1});
  EXPECT_EQ(static_cast<std::int64_t>(undone.changedBlocks), done.blocks);
  EXPECT_EQ(compare(before, sculptor.field()).corners, 0);
  const Step& step = *sculptor.history().tree().find(2);
  EXPECT_EQ(static_cast<std::int64_t>(step.changedBlocks), done.blocks);
}

}  // namespace
}  // namespace bozzetto
