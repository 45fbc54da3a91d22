#include "bozzetto/field/difference.hpp"

#include <algorithm>

namespace bozzetto {
namespace {

void add(KeyBox& box, Key key) {
  if (box.empty()) box = {key, key};
  for (const Axis axis : kAxes) {
    box.low[axis] = std::min(box.low[axis], key[axis]);
    box.high[axis] = std::max(box.high[axis], key[axis]);
  }
}

template <int Side>
struct Counter {
  using Block = CornerBlock<Side>;
  using Geometry = BlockGeometry<Side>;

  FieldDifference found;

  // Where the two blocks of a run differ; null stands for empty space.
  void look(KeyRun run, const Block* before, const Block* after) {
    static const Block nothing;
    const Block& a = before != nullptr ? *before : nothing;
    const Block& b = after != nullptr ? *after : nothing;
    found.blocks += run.length;
    const Key first = Geometry::firstCornerOf(run.key);
    const Key onwards{0, 0, (run.length - 1) * Side};
    for (int n = 0; n < Geometry::kCount; ++n) {
      const bool reshaped = a.value[n] != b.value[n];
      if (!reshaped && a.attributes[n] == b.attributes[n]) continue;
      const Key corner = first + Key{n / (Side * Side), n / Side % Side, n % Side};
      found.corners += run.length;
      if (reshaped) found.reshaped += run.length;
      add(found.bounds, corner);
      add(found.bounds, corner + onwards);
    }
  }
};

template <int Side>
double massOf(const Field<Side>& field) {
  const double spacing = field.scale.spacing;
  return static_cast<double>(massUnits(field)) * kMassUnit * (spacing * spacing * spacing);
}

}  // namespace

namespace {

// Where the two do not share their block; null stands for empty space.
template <int Side, class Visit>
void forDiffering(const Field<Side>& before, const Field<Side>& after, Visit visit) {
  using Block = CornerBlock<Side>;
  // All that was, against what is there now.
  for (const auto& [key, run] : before.tree) {
    const Ref<Block>& old = run.block;
    forPieces(after.tree, {key, run.length}, [&](KeyRun piece, const Ref<Block>& now) {
      if (!(old == now)) visit(piece, old.get(), now.get());
    });
  }
  // What is there now where nothing was.
  for (const auto& [key, run] : after.tree) {
    const Ref<Block>& now = run.block;
    forPieces(before.tree, {key, run.length}, [&](KeyRun piece, const Ref<Block>& old) {
      if (!old) visit(piece, static_cast<const Block*>(nullptr), now.get());
    });
  }
}

}  // namespace

template <int Side>
FieldDifference compare(const Field<Side>& before, const Field<Side>& after) {
  Counter<Side> counter;
  forDiffering(before, after, [&](KeyRun piece, const auto* old, const auto* now) {
    counter.look(piece, old, now);
  });
  counter.found.massBefore = massOf(before);
  counter.found.massAfter = massOf(after);
  return counter.found;
}

template <int Side>
std::vector<KeyRun> differingBlocks(const Field<Side>& before, const Field<Side>& after) {
  std::vector<KeyRun> runs;
  forDiffering(before, after,
               [&](KeyRun piece, const auto*, const auto*) { runs.push_back(piece); });
  std::ranges::sort(runs, {}, &KeyRun::key);
  return runs;
}

template std::vector<KeyRun> differingBlocks(const Field<1>&, const Field<1>&);
template std::vector<KeyRun> differingBlocks(const Field<8>&, const Field<8>&);
template FieldDifference compare(const Field<1>&, const Field<1>&);
template FieldDifference compare(const Field<8>&, const Field<8>&);

}  // namespace bozzetto
