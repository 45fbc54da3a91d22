#include "io/empty_rows.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "bozzetto/base/parallel.hpp"

namespace bozzetto {
namespace {

constexpr double kSide = 8;
// How near ½ a block's middle may come before the level may pass through the block: 7 cells at the
// steepest slope that is left one block away from an open edge, 1/(2π·8) a cell.
constexpr double kLevelMargin = 0.15;
constexpr std::int64_t kMostOpenBlocks = std::int64_t{1} << 27;

glm::dvec3 middleOf(Key block) {
  return glm::dvec3(block.i, block.j, block.k) * kSide + glm::dvec3((kSide - 1) / 2);
}

// The gaps between touched blocks of one row; what lies outside the outermost is outside.
std::vector<KeyRun> gapsBetween(const std::vector<BlockTask>& tasks) {
  std::vector<KeyRun> gaps;
  for (std::size_t n = 1; n < tasks.size(); ++n) {
    const Key a = tasks[n - 1].block, b = tasks[n].block;
    if (a.i != b.i || a.j != b.j || b.k == a.k + 1) continue;
    gaps.push_back({{a.i, a.j, a.k + 1}, b.k - a.k - 1});
  }
  return gaps;
}

std::vector<KeyRun> solidGaps(const WindingTree& winding, const std::vector<BlockTask>& tasks) {
  const auto gaps = gapsBetween(tasks);
  std::vector<std::uint8_t> solid(gaps.size(), 0);
  parallelFor(gaps.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      solid[n] = winding.at(middleOf(gaps[n].key)) > 0.5;
    }
  });
  std::vector<KeyRun> rows;
  for (std::size_t n = 0; n < gaps.size(); ++n) {
    if (solid[n] != 0) rows.push_back(gaps[n]);
  }
  return rows;
}

// Every block of the box of an open mesh.
class OpenBlocks {
 public:
  OpenBlocks(const GridMesh& grid, const WindingTree& winding)
      : grid_(grid), winding_(winding), size_(grid.blocks) {
    const std::int64_t count = std::int64_t{size_.i} * size_.j * size_.k;
    if (std::int64_t{size_.i} * size_.j > kMostOpenBlocks || count > kMostOpenBlocks) {
      throw Error(
          "import: found an open mesh in a box of more than 2^27 blocks, expected less: "
          "take fewer cells");
    }
    state_.resize(static_cast<std::size_t>(count), State::outside);
  }

  void markTouched(const std::vector<BlockTask>& tasks) {
    for (const auto& task : tasks) at(task.block) = State::touched;
  }

  // Asks the winding number at the middle of all other blocks.
  void classify(Progress& progress) {
    for (std::int32_t i = 0; i < size_.i; ++i) {
      progress.step("Closing holes", double(i) / double(size_.i));
      parallelFor(static_cast<std::size_t>(size_.j), 1, [&](std::size_t begin, std::size_t end) {
        for (auto j = static_cast<std::int32_t>(begin); j < static_cast<std::int32_t>(end); ++j) {
          for (std::int32_t k = 0; k < size_.k; ++k) classifyBlock({i, j, k});
        }
      });
    }
  }

  // Untouched blocks through which the ½ level may pass.
  std::vector<BlockTask> levelBlocks() const {
    std::vector<BlockTask> found;
    forEach([&](Key key) {
      const State state = at(key);
      if (state == State::touched) return;
      bool passes = state == State::nearLevel || state == State::nearLevelInside;
      forNeighbours(key, [&](Key other) {
        passes = passes || (at(other) != State::touched && isInside(at(other)) != isInside(state));
      });
      if (passes) found.push_back({key, BlockKind::level, {}});
    });
    return found;
  }

  std::vector<KeyRun> solidRows() const {
    std::vector<KeyRun> rows;
    forEach([&](Key key) {
      if (!isInside(at(key))) return;
      const bool next = !rows.empty() && rows.back().key.i == key.i && rows.back().key.j == key.j &&
                        rows.back().key.k + rows.back().length == key.k;
      if (next) ++rows.back().length;
      if (!next) rows.push_back({key, 1});
    });
    return rows;
  }

  // Blocks with an open edge become holes, those next to them rims.
  void markHoles(std::vector<BlockTask>& tasks) const {
    std::vector<std::uint8_t> near(state_.size(), 0);
    for (const auto& pair : touchedBlocks(grid_.mesh.positions, grid_.openEdges, 1)) {
      const Key key = unpackBlock(pair.block);
      near[indexOf(key)] = 2;
      forNeighbours(key, [&](Key other) {
        near[indexOf(other)] = std::max<std::uint8_t>(near[indexOf(other)], 1);
      });
    }
    for (auto& task : tasks) {
      const auto nearness = near[indexOf(task.block)];
      const bool level = task.kind == BlockKind::level;
      if (nearness == 2 || (nearness == 1 && level)) task.kind = BlockKind::holes;
      if (nearness == 1 && !level) task.kind = BlockKind::rim;
    }
  }

 private:
  enum class State : std::uint8_t { outside, inside, nearLevel, nearLevelInside, touched };

  static bool isInside(State state) {
    return state == State::inside || state == State::nearLevelInside;
  }

  void classifyBlock(Key key) {
    if (at(key) == State::touched) return;
    const double winding = winding_.at(middleOf(key));
    const bool inside = winding > 0.5;
    const bool near = std::abs(winding - 0.5) < kLevelMargin;
    at(key) = near ? (inside ? State::nearLevelInside : State::nearLevel)
                   : (inside ? State::inside : State::outside);
  }

  std::size_t indexOf(Key key) const {
    return (static_cast<std::size_t>(key.i) * static_cast<std::size_t>(size_.j) +
            static_cast<std::size_t>(key.j)) *
               static_cast<std::size_t>(size_.k) +
           static_cast<std::size_t>(key.k);
  }
  State& at(Key key) { return state_[indexOf(key)]; }
  State at(Key key) const { return state_[indexOf(key)]; }

  template <class Visit>
  void forEach(Visit visit) const {
    for (Key key{0, 0, 0}; key.i < size_.i; ++key.i) {
      for (key.j = 0; key.j < size_.j; ++key.j) {
        for (key.k = 0; key.k < size_.k; ++key.k) visit(key);
      }
    }
  }

  template <class Visit>
  void forNeighbours(Key key, Visit visit) const {
    const KeyBox box{{0, 0, 0}, size_ - Key{1, 1, 1}};
    for (int n = 0; n < 27; ++n) {
      const Key other = key + Key{n / 9 - 1, n / 3 % 3 - 1, n % 3 - 1};
      if (n != 13 && box.contains(other)) visit(other);
    }
  }

  const GridMesh& grid_;
  const WindingTree& winding_;
  Key size_;
  std::vector<State> state_;
};

}  // namespace

std::vector<KeyRun> emptyRows(const GridMesh& grid, const WindingTree& winding,
                              std::vector<BlockTask>& tasks, Progress& progress) {
  if (grid.openEdges.empty()) return solidGaps(winding, tasks);
  OpenBlocks blocks(grid, winding);
  blocks.markTouched(tasks);
  blocks.classify(progress);
  const auto level = blocks.levelBlocks();
  tasks.insert(tasks.end(), level.begin(), level.end());
  std::sort(tasks.begin(), tasks.end(),
            [](const BlockTask& a, const BlockTask& b) { return a.block < b.block; });
  blocks.markHoles(tasks);
  blocks.markTouched(level);
  return blocks.solidRows();
}

}  // namespace bozzetto
