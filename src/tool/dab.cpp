#include "bozzetto/tool/dab.hpp"

#include <algorithm>

#include "tool/block_work.hpp"
#include "tool/handled_body.hpp"
#include "tool/local_count.hpp"
#include "tool/lowpass.hpp"
#include "tool/swept.hpp"

namespace bozzetto {
namespace {

// Work of some 50 µs a thread, at 0.25 µs a block of 512 corners and thrice that for low-passing.
template <int Side>
constexpr std::size_t grainFor(const Action& action) {
  const std::size_t corners = action.wantsLowpass() ? 32 * 512 : 192 * 512;
  return corners / (Side * Side * Side) / (Side == 1 ? 10 : 1);
}

// Blocks are listed until so many corners wait, then made and put into the tree: enough to share
// between threads, or few enough to stay in the cache of one.
std::size_t batchCorners() { return std::size_t{1} << (threadCount() > 1 ? 20 : 15); }

template <int Side>
BlockSummary summaryOf(const CornerBlock<Side>* block) {
  if (block == nullptr) return {};
  const bool uniform = block->interned || Side == 1;
  return {true, uniform, block->value[0], block->attributes[0]};
}

// The head and the values, while the block before is worked on.
template <int Side>
void prefetch(const CornerBlock<Side>* block) {
  if (Side == 1 || block == nullptr || block->interned) return;
  constexpr std::size_t line = 64 / sizeof(float);
  for (std::size_t n = 0; n < CornerBlock<Side>::kCount; n += line)
    __builtin_prefetch(&block->value[n]);
}

}  // namespace

void DabReport::add(const DabReport& other) {
  visited += other.visited;
  computed += other.computed;
  dirty += other.dirty;
  dropped += other.dropped;
  changed.insert(changed.end(), other.changed.begin(), other.changed.end());
}

template <int Side>
struct DabWalker<Side>::Walk {
  using Geometry = BlockGeometry<Side>;
  const Dab& dab;
  const StampTool* handled = nullptr;  // the tool, where it has a handle
  LocalFrame frame;
  KeyBox blocks;

  Walk(const Dab& walked, const KeyBox& box)
      : dab(walked),
        handled(walked.swept == nullptr ? nullptr
                                        : dynamic_cast<const StampTool*>(walked.potential)),
        frame(walked.potential->frame(walked.pose)),
        blocks{Geometry::blockOf(box.low), Geometry::blockOf(box.high)} {
    if (handled != nullptr && !handled->hasHandle()) handled = nullptr;
  }

  // The first corner of a block, counted from the dab's own cell.
  Key offsetOf(Key block) const { return Geometry::firstCornerOf(block) - frame.cell; }

  // The tool has no potential anywhere in these blocks.
  bool misses(KeyRun run) const {
    const Key low = offsetOf(run.key);
    constexpr int rim = Side - 1;
    return dab.potential->misses(frame, low, low + Key{rim, rim, run.length * Side - 1});
  }

  bool bodyMisses(Key block) const {
    if (handled != nullptr) return false;
    const Key low = offsetOf(block);
    return dab.potential->bodyMisses(frame, low, low + Key{Side - 1, Side - 1, Side - 1});
  }

  std::int32_t columnLength() const { return blocks.high.k - blocks.low.k + 1; }

  // Place of a block in the table of the neighbourhood.
  std::size_t placeOf(Key block) const {
    const Key at = block - blocks.low + Key{1, 1, 1};
    const auto wideJ = static_cast<std::size_t>(blocks.high.j - blocks.low.j + 3);
    const auto wideK = static_cast<std::size_t>(columnLength() + 2);
    return (static_cast<std::size_t>(at.i) * wideJ + static_cast<std::size_t>(at.j)) * wideK +
           static_cast<std::size_t>(at.k);
  }
};

template <int Side>
void DabWalker<Side>::apply(const Dab& dab, DabReport& report) {
  const DabPose influence = influenceOf(*dab.potential, dab.pose);
  const KeyBox box = dabBox(influence);
  const Walk walk(dab, box);
  const LocalFrame frame = localFrame(influence);
  report.visited += box.count();
  report.computed += countLocal(frame, box.low - frame.cell, box.high - frame.cell);
  left_ = this;  // nothing yet
  // Low-passing reads the old neighbours: there, nothing is written before everything is made.
  const bool lowpass = dab.action->wantsLowpass();
  if (lowpass) gatherNeighbourhood(walk);
  const std::size_t batch = batchCorners() / Block::kCount;
  for (std::int32_t bi = walk.blocks.low.i; bi <= walk.blocks.high.i; ++bi) {
    for (std::int32_t bj = walk.blocks.low.j; bj <= walk.blocks.high.j; ++bj) {
      listColumn(walk, bi, bj);
      if (lowpass || work_.size() < batch) continue;
      compute(walk);
      writeAll(*edit_, work_, report);
    }
  }
  compute(walk);
  writeAll(*edit_, work_, report);
}

template <int Side>
void DabWalker<Side>::listColumn(const Walk& walk, std::int32_t bi, std::int32_t bj) {
  const KeyRun column{{bi, bj, walk.blocks.low.k}, walk.columnLength()};
  if (walk.misses(column)) return;
  edit_->visit(column, [&](KeyRun piece, const Block* block) { listPiece(walk, piece, block); });
}

// Blocks are looked into only where the tool reaches them; a saturated inside is one block in many
// nodes, asked about once.
template <int Side>
void DabWalker<Side>::listPiece(const Walk& walk, KeyRun piece, const Block* block) {
  const Action& action = *walk.dab.action;
  const bool lowpass = action.wantsLowpass();
  if (block == left_) return;
  if (piece.length == 1 && walk.misses(piece)) return;
  if (!lowpass && action.leaves(summaryOf(block))) {
    if (block == nullptr || block->interned) left_ = block;
    return;
  }
  for (std::int32_t n = 0; n < piece.length; ++n) {
    const Key key = piece.key + Key{0, 0, n};
    if (piece.length > 1 && walk.misses({key, 1})) continue;
    SweptBlock<Side>* const swept = sweptAt(walk, key);
    if (walk.handled != nullptr) swept->note(block);
    work_.push_back({key, block, nullptr, {}, false, swept});
  }
}

// Made here, before threads look at their own ones only.
template <int Side>
SweptBlock<Side>* DabWalker<Side>::sweptAt(const Walk& walk, Key block) {
  auto* const swept = walk.dab.swept;
  if (swept == nullptr) return nullptr;
  if (!walk.bodyMisses(block)) return &(*swept)[block];
  const auto found = swept->find(block);
  return found == swept->end() ? nullptr : &found->second;
}

// The blocks of the dab and a rim of one, in a dense table.
template <int Side>
void DabWalker<Side>::gatherNeighbourhood(const Walk& walk) {
  const Key low = walk.blocks.low - Key{1, 1, 1}, high = walk.blocks.high + Key{1, 1, 1};
  neighbourhood_.assign(walk.placeOf(high) + 1, nullptr);
  for (std::int32_t bi = low.i; bi <= high.i; ++bi) {
    for (std::int32_t bj = low.j; bj <= high.j; ++bj) {
      const KeyRun column{{bi, bj, low.k}, high.k - low.k + 1};
      edit_->visit(column, [&](KeyRun piece, const Block* block) {
        std::fill_n(neighbourhood_.begin() + static_cast<std::ptrdiff_t>(walk.placeOf(piece.key)),
                    piece.length, block);
      });
    }
  }
}

template <int Side>
void DabWalker<Side>::compute(const Walk& walk) {
  parallelFor(work_.size(), grainFor<Side>(*walk.dab.action),
              [&](std::size_t begin, std::size_t end) {
                for (std::size_t n = begin; n < end; ++n) {
                  if (n + 1 < end) prefetch(work_[n + 1].old);
                  compute(walk, work_[n]);
                }
              });
}

template <int Side>
void DabWalker<Side>::compute(const Walk& walk, BlockWork<Side>& work) const {
  const Action& action = *walk.dab.action;
  Neighbourhood<Side> near;
  if (action.wantsLowpass()) {
    int n = 0;
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j)
        for (int k = -1; k <= 1; ++k)
          near[n++] = neighbourhood_[walk.placeOf(work.key + Key{i, j, k})];
    const bool alike = std::all_of(near.begin(), near.end(), [&](auto* b) { return b == near[0]; });
    if (alike && action.leaves(summaryOf(near[0]))) return sweep(walk, work);
  }

  alignas(64) float potential[Block::kCount], body[Block::kCount];
  const Key first = walk.offsetOf(work.key);
  if (action.wantsBody()) {
    walk.dab.potential->evaluateWithBody(walk.frame, first, Side, potential, body);
  } else {
    walk.dab.potential->evaluate(walk.frame, first, Side, potential);
  }

  LowpassBuffer<Side> buffer;
  if (action.wantsLowpass()) lowpass<Side>(near, buffer);

  const auto in = action.wantsLowpass() ? WriteTo::fresh : WriteTo::own;
  BlockView view = viewOf(*edit_, work, in);
  view.potential = potential;
  view.lowpass = &buffer.result;
  alignas(64) Attributes colours[Block::kCount];
  if (action.wantsColours()) {
    walk.dab.potential->evaluateColours(walk.frame, first, Side, colours);
    view.toolColours = colours;
  }
  view.body = body;
  view.swept = (work.swept == nullptr ? unswept<Side>() : *work.swept).shares();
  alignas(64) float most[Block::kCount];
  if (walk.handled != nullptr) {
    addHandle<Side>(*walk.handled, walk.frame, first, work.swept->before(work.old), body);
    std::transform(body, body + Block::kCount, view.swept, most,
                   [](float a, float b) { return std::max(a, b); });
    view.swept = most;
  }
  work.outcome = action.apply(view, walk.dab.strength);
  if (work.swept != nullptr) work.swept->add(body);
}

// Where the tool goes through the air, or through what is held.
template <int Side>
void DabWalker<Side>::sweep(const Walk& walk, const BlockWork<Side>& work) const {
  if (work.swept == nullptr || walk.bodyMisses(work.key)) return;
  alignas(64) float body[Block::kCount];
  const Key first = walk.offsetOf(work.key);
  walk.dab.potential->evaluateBody(walk.frame, first, Side, body);
  if (walk.handled != nullptr)
    addHandle<Side>(*walk.handled, walk.frame, first, work.swept->before(work.old), body);
  work.swept->add(body);
}

template class DabWalker<1>;
template class DabWalker<8>;

}  // namespace bozzetto
