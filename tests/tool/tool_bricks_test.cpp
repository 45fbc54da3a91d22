// What boxes of tools say of themselves, against a look at every corner.
#include "bozzetto/grid/key_box.hpp"
#include "bozzetto/tool/sculpture.hpp"
#include "tool/tool_box.hpp"
#include "tool/tool_fixture.hpp"

namespace bozzetto {
namespace {

using namespace testing;

struct BoxOfTool {
  Clay clay = clayBall<8>(21);
  ToolBox box{clay, boundsOf(clay)};

  float at(Key corner) const {
    const Key last{box.wide[0] - 1, box.wide[1] - 1, box.wide[2] - 1};
    if (!KeyBox{{0, 0, 0}, last}.contains(corner)) return 0;
    return box.value[std::size_t((corner.i * box.wide[1] + corner.j) * box.wide[2] + corner.k)];
  }
  ToolKind kindOf(Key low, Key high) const {
    const float first = at(low);
    bool alike = first == 0 || first == 1;
    forKeys({low, high}, [&](Key corner) { alike = alike && at(corner) == first; });
    if (!alike) return ToolKind::varied;
    return first > 0 ? ToolKind::full : ToolKind::empty;
  }
};

TEST(ToolBricks, neverMistakeWhatIsNear) {
  const BoxOfTool tool;
  int empty = 0, full = 0, missed = 0;
  for (int n = 0; n < 4000; ++n) {
    const Key low{n * 7 % 47 - 4, n * 13 % 49 - 4, n * 29 % 67 + 4};
    const Key high = low + Key{n % 9, n % 5 + 1, n % 13};
    const ToolKind found = tool.box.bricks.kindOf(low, high), is = tool.kindOf(low, high);
    ASSERT_TRUE(found == is || found == ToolKind::varied) << toText(low) << toText(high);
    empty += found == ToolKind::empty;
    full += found == ToolKind::full;
    missed += found != is;
  }
  EXPECT_GT(empty, 500);
  EXPECT_GT(full, 200);
  EXPECT_LT(missed, 900);
}

TEST(ToolBricks, cellsKnowTheirCorners) {
  const BoxOfTool tool;
  int full = 0;
  for (int n = 0; n < 20000; ++n) {
    const Key at{n * 7 % 45, n * 13 % 45, n * 29 % 73};
    const auto entry = std::size_t((at.i * tool.box.wide[1] + at.j) * tool.box.wide[2] + at.k);
    const ToolKind kind = tool.box.kinds[entry];
    ASSERT_EQ(kind, tool.kindOf(at, at + Key{1, 1, 1})) << toText(at);
    full += kind == ToolKind::full;
  }
  EXPECT_GT(full, 1000);
}

}  // namespace
}  // namespace bozzetto
