#include "bozzetto/tool/combine.hpp"

#include <algorithm>
#include <array>

#include "bozzetto/base/error.hpp"
#include "bozzetto/base/text.hpp"
#include "bozzetto/tool/relative.hpp"
#include "tool/block_work.hpp"
#include "tool/corner_loop.hpp"
#include "tool/freeform.hpp"
#include "tool/share.hpp"

namespace bozzetto {
namespace {

constexpr std::array<std::string_view, 3> kNames{"union", "subtract", "intersect"};

struct UniteRule {
  const float* potential;
  const Attributes* tool;
  BOZZETTO_KERNEL Corner operator()(Corner old, int n) const {
    const float rise = positive(pull(1.0f, potential[n] - old.value, old.attributes));
    const auto raised = positiveMask(rise);
    const auto free = signMask(static_cast<std::int32_t>(old.attributes >> 24) - 1);
    const float value = pick(free, potential[n], old.value + rise);
    const Attributes painted = (tool[n] & kColourBits) | (old.attributes & kHoldBits);
    return {pick(raised, value, old.value),
            pick(raised & yieldMask(old.attributes), painted, old.attributes)};
  }
};

// Down to 1 − p or to p.
template <Combining kHow>
struct LowerRule {
  const float* potential;
  BOZZETTO_KERNEL Corner operator()(Corner old, int n) const {
    const float p = potential[n], target = kHow == Combining::subtract ? 1.0f - p : p;
    const float fall = positive(pull(1.0f, old.value - target, old.attributes));
    const auto free = signMask(static_cast<std::int32_t>(old.attributes >> 24) - 1);
    const float value = pick(free, target, old.value - fall);
    return {pick(positiveMask(fall), value, old.value), old.attributes};
  }
};

class Combine final : public Action {
 public:
  explicit Combine(Combining how) : how_(how) {}
  bool leaves(const BlockSummary& block) const override {
    if (!block.present) return how_ != Combining::unite;
    return block.uniform && holdOf(block.attributes) == 255;
  }
  bool wantsColours() const override { return how_ == Combining::unite; }
  Outcome apply(const BlockView& block, float) const override {
    if (how_ == Combining::unite) return run(block, UniteRule{block.potential, block.toolColours});
    if (how_ == Combining::subtract)
      return run(block, LowerRule<Combining::subtract>{block.potential});
    return run(block, LowerRule<Combining::intersect>{block.potential});
  }

 private:
  Combining how_;
};

// Where the sculpture is not, its density is 0: for intersections nothing misses.
class Everywhere final : public Potential {
 public:
  Everywhere(const Potential& inner, const glm::dvec3& reach) : inner_(&inner), reach_(reach) {}
  LocalFrame frame(const DabPose& pose) const override { return inner_->frame(pose); }
  glm::dvec3 reach() const override { return reach_; }
  bool misses(const LocalFrame&, Key, Key) const override { return false; }
  void evaluate(const LocalFrame& frame, Key first, int side, float* potential) const override {
    if (inner_->misses(frame, first, first + Key{side - 1, side - 1, side - 1})) {
      std::fill_n(potential, side * side * side, 0.0f);
    } else {
      inner_->evaluate(frame, first, side, potential);
    }
  }

 private:
  const Potential* inner_;
  glm::dvec3 reach_;
};

DabPose poseOf(const Sculpture& sculpture, const FieldScale& scale, const CombinePose& pose) {
  const double ratio = sculpture.scale().spacing / scale.spacing;
  const glm::dmat3 turn = glm::mat3_cast(normalisedRotation(pose.rotation));
  const glm::dvec3 centre = turn * (sculpture.centre() * pose.scale * ratio);
  DabPose made;
  made.origin = cellOf(pose.at, scale.spacing, "combine");
  made.position = relativeTo(made.origin, pose.at, scale.spacing) + centre;
  made.orientation = turn;
  made.radii = sculpture.halfExtents() * pose.scale * ratio;
  return made;
}

// Blocks inside stay shared whatever the scale, the others do not.
void requireBearable(const Sculpture& sculpture, const FieldScale& scale, const glm::dvec3& grown) {
  constexpr double kMostCorners = double(std::int64_t{1} << 32);
  const double ratio = sculpture.scale().spacing / scale.spacing;
  double blocks = 0;
  for (const auto& [key, run] : sculpture.clay().tree) blocks += run.block->interned ? 0 : 1;
  const double corners =
      blocks * Clay::Block::kCount * grown.x * grown.y * grown.z * ratio * ratio * ratio;
  if (corners > kMostCorners) {
    throw Error("combine: about " + numberText(corners) +
                " corners at this scale, at most 2^32 expected");
  }
}

struct ClearRule {
  const float* share;
  BOZZETTO_KERNEL Corner operator()(Corner old, int n) const {
    return {pick(yieldMask(old.attributes), restOf(old.value, share[n]), old.value),
            old.attributes};
  }
};

// Takes away the share of one block's corners that `wanted` says.
template <int Side, class Wanted>
void clearBlock(Edit<CornerBlock<Side>>& edit, Key key, Wanted&& wanted, DabReport& report) {
  using Block = CornerBlock<Side>;
  alignas(64) float share[Block::kCount];
  const Key first = BlockGeometry<Side>::firstCornerOf(key);
  int n = 0;
  for (int i = 0; i < Side; ++i)
    for (int j = 0; j < Side; ++j)
      for (int k = 0; k < Side; ++k) share[n++] = static_cast<float>(wanted(first + Key{i, j, k}));
  Block& block = edit.write(key);
  float* value = block.value.data();
  Attributes* attributes = block.attributes.data();
  const BlockView view{Block::kCount, value, attributes, value,
                       attributes,    share, nullptr,    nullptr};
  const Outcome outcome = run(view, ClearRule{share});
  describe(block, outcome);
  report.dirty += outcome.dirty;
  report.changed.push_back({key, outcome.corners});
}

// The blocks of the tree that `wanted` says.
template <int Side, class Wanted>
std::vector<Key> blocksOf(const KeyTree<CornerBlock<Side>>& tree, Wanted&& wanted) {
  std::vector<Key> blocks;
  for (const auto& [key, run] : tree)
    for (std::int32_t n = 0; n < run.length; ++n)
      if (wanted(key + Key{0, 0, n})) blocks.push_back(key + Key{0, 0, n});
  return blocks;
}

// Empties the blocks that the dab does not reach.
template <int Side>
void emptyOutside(Edit<CornerBlock<Side>>& edit, const KeyBox& box, DabReport& report) {
  using Geometry = BlockGeometry<Side>;
  const KeyBox reached{Geometry::blockOf(box.low), Geometry::blockOf(box.high)};
  for (const Key& key : blocksOf(edit.tree(), [&](Key at) { return !reached.contains(at); }))
    clearBlock(
        edit, key, [](Key) { return 1; }, report);
}

}  // namespace

std::string_view toText(Combining how) { return kNames[static_cast<std::size_t>(how)]; }

std::optional<Combining> combiningNamed(std::string_view name) {
  for (std::size_t n = 0; n < kNames.size(); ++n)
    if (kNames[n] == name) return static_cast<Combining>(n);
  return std::nullopt;
}

template <int Side>
DabReport combine(Edit<CornerBlock<Side>>& edit, const FieldScale& scale,
                  std::shared_ptr<const Sculpture> sculpture, Combining how,
                  const CombinePose& pose) {
  freeformRadii(*sculpture, pose.scale);
  requireBearable(*sculpture, scale, pose.scale);
  const DabPose dab = poseOf(*sculpture, scale, pose);
  if (minification(*sculpture, dab.radii) > kMostMinified) {
    throw Error("combine: more than 256 cells of one to a cell of the other");
  }
  const auto potential = makeFreeform(sculpture, dab.radii);
  const KeyBox box = dabBox(influenceOf(*potential, dab));
  const Combine action(how);
  DabReport report;
  DabWalker<Side> walker(edit);
  if (how == Combining::intersect) {
    walker.apply(
        {dab, std::make_unique<Everywhere>(*potential, potential->reach()).get(), &action, 1},
        report);
    emptyOutside(edit, box, report);
  } else {
    walker.apply({dab, potential.get(), &action, 1}, report);
  }
  return report;
}

template <int Side>
DabReport clear(Edit<CornerBlock<Side>>& edit, const KeyBox& box) {
  using Geometry = BlockGeometry<Side>;
  DabReport report;
  if (box.empty()) return report;
  const KeyBox blocks{Geometry::blockOf(box.low), Geometry::blockOf(box.high)};
  for (const Key& key : blocksOf(edit.tree(), [&](Key at) { return blocks.contains(at); }))
    clearBlock(
        edit, key, [&](Key corner) { return box.contains(corner); }, report);
  return report;
}

template <int Side>
DabReport clear(Edit<CornerBlock<Side>>& edit, const FieldScale& scale, const KeyBox& box,
                const Lasso& lasso) {
  using Geometry = BlockGeometry<Side>;
  requireValid(lasso);
  DabReport report;
  if (box.empty()) return report;
  const auto place = [&](Key corner) {
    return glm::dvec3(corner.i, corner.j, corner.k) * scale.spacing;
  };
  const KeyBox blocks{Geometry::blockOf(box.low), Geometry::blockOf(box.high)};
  const double half = (Side - 1) / 2.0 * scale.spacing, radius = (half + scale.spacing) * 1.75;
  const auto share = [&](Key corner) {
    return box.contains(corner) ? lasso.share(place(corner), scale.spacing) : 0;
  };
  const auto wanted = [&](Key at) {
    if (!blocks.contains(at)) return false;
    return coverageOf(lasso, place(Geometry::firstCornerOf(at)) + half, radius) != Coverage::none;
  };
  for (const Key& key : blocksOf(edit.tree(), wanted)) clearBlock(edit, key, share, report);
  return report;
}

template DabReport combine(Edit<CornerBlock<1>>&, const FieldScale&,
                           std::shared_ptr<const Sculpture>, Combining, const CombinePose&);
template DabReport combine(Edit<CornerBlock<8>>&, const FieldScale&,
                           std::shared_ptr<const Sculpture>, Combining, const CombinePose&);
template DabReport clear(Edit<CornerBlock<1>>&, const KeyBox&);
template DabReport clear(Edit<CornerBlock<8>>&, const KeyBox&);
template DabReport clear(Edit<CornerBlock<1>>&, const FieldScale&, const KeyBox&, const Lasso&);
template DabReport clear(Edit<CornerBlock<8>>&, const FieldScale&, const KeyBox&, const Lasso&);

}  // namespace bozzetto
