#include "bozzetto/tool/fill.hpp"

#include <algorithm>
#include <cmath>

#include "bozzetto/base/text.hpp"
#include "bozzetto/tool/relative.hpp"
#include "bozzetto/tool/solid.hpp"
#include "tool/block_work.hpp"
#include "tool/corner_loop.hpp"

namespace bozzetto {
namespace {

constexpr double kMostBlocks = 1 << 23;
constexpr double kSlope = 1;           // cells from the surface to where the value is 0 or 1
constexpr double kUncertainty = 0.05;  // of distances, cells

// Raises values to those of the primitive, which stand in place of a potential.
struct FillRule {
  const float* target;
  Attributes colour;

  BOZZETTO_KERNEL Corner operator()(Corner old, int n) const {
    const float rise = pull(1.0f, target[n] - old.value, old.attributes);
    const auto free = signMask(static_cast<std::int32_t>(old.attributes >> 24) - 1);
    const auto raised = lessMask(old.value, target[n]) & positiveMask(positive(rise));
    const auto coloured = raised & yieldMask(old.attributes);
    const float value = pick(free, target[n], old.value + rise);
    return {pick(raised, value, old.value),
            pick(coloured, colour | (old.attributes & kHoldBits), old.attributes)};
  }
};

// What the blocks of a column are to the primitive.
struct Plan {
  std::vector<KeyRun> inside, surface;
};

void append(std::vector<KeyRun>& runs, KeyRun run) {
  const bool joins = !runs.empty() && runs.back().key + Key{0, 0, runs.back().length} == run.key;
  joins ? void(runs.back().length += run.length) : runs.push_back(run);
}

void requireAffordable(const glm::dvec3& radii, int side) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!(radii[axis] > 0) || !std::isfinite(radii[axis])) {
      throw Error("fill radius: " + numberText(radii[axis]) +
                  " cells found, a number above 0 expected");
    }
  }
  const glm::dvec3 r = radii + 1.0;
  const double area = 8 * (r.x * r.y + r.y * r.z + r.z * r.x), volume = 8 * r.x * r.y * r.z;
  const double blocks = side > 1 ? 2 * area / (side * side) : volume / 16;
  if (!(blocks <= kMostBlocks)) {
    throw Error("fill: a surface of about " + numberText(blocks) +
                " blocks found, at most 8388608 expected; use smaller radii or a larger spacing");
  }
}

template <int Side>
class Filler {
 public:
  using Block = CornerBlock<Side>;
  using Geometry = BlockGeometry<Side>;

  Filler(Edit<Block>& edit, const Primitive& primitive, const DabPose& pose)
      : edit_(edit),
        solid_(makeSolid(primitive.shape, pose)),
        colour_(packAttributes(primitive.colour)) {
    DabPose reach = pose;
    reach.radii += kSlope;
    box_ = dabBox(reach);
    blocks_ = {Geometry::blockOf(box_.low), Geometry::blockOf(box_.high)};
  }

  // Slab by slab of equal i, so that little waits in memory.
  DabReport run(Progress& progress) {
    DabReport report;
    report.visited = box_.count();
    for (std::int32_t bi = blocks_.low.i; bi <= blocks_.high.i; ++bi) {
      planSlab(bi);
      for (const Plan& plan : plans_) list(plan);
      report.computed += static_cast<std::int64_t>(work_.size()) * Block::kCount;
      compute();
      put(report);
      writeAll(edit_, work_, report);
      const double done = double(bi) - blocks_.low.i + 1;
      progress.step("fill", done / (double(blocks_.high.i) - blocks_.low.i + 1));
    }
    return report;
  }

 private:
  void planSlab(std::int32_t bi) {
    plans_.resize(static_cast<std::size_t>(blocks_.high.j - blocks_.low.j + 1));
    parallelFor(plans_.size(), 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) {
        plans_[n].inside.clear();
        plans_[n].surface.clear();
        planColumn(bi, blocks_.low.j + static_cast<std::int32_t>(n), plans_[n]);
      }
    });
  }

  // Distances change by at most 8 cells from block to block: those far from the surface are
  // stepped over as many at a time as the distance allows.
  void planColumn(std::int32_t bi, std::int32_t bj, Plan& plan) const {
    const double rim = kSlope + kUncertainty + 0.5 * std::sqrt(3.0) * (Side - 1);
    for (std::int32_t bk = blocks_.low.k; bk <= blocks_.high.k;) {
      const Key key{bi, bj, bk};
      const Key low = Geometry::firstCornerOf(key) - solid_->cell;
      const double distance = solid_->distance(glm::dvec3(low.i, low.j, low.k) + 0.5 * (Side - 1));
      const double room = (std::abs(distance) * (1 - 1e-6) - rim) / Side;
      const auto most = std::int64_t{blocks_.high.k} - bk + 1;
      const auto steps = room < 0 ? 1 : std::min(most, 1 + static_cast<std::int64_t>(room));
      const KeyRun run{key, static_cast<std::int32_t>(steps)};
      if (room < 0) append(plan.surface, run);
      if (room >= 0 && distance < 0) append(Side > 1 ? plan.inside : plan.surface, run);
      bk += run.length;
    }
  }

  void list(const Plan& plan) {
    const auto listEach = [&](KeyRun run, const Block* block) {
      for (std::int32_t n = 0; n < run.length; ++n)
        work_.push_back({run.key + Key{0, 0, n}, block, nullptr, {}});
    };
    for (const KeyRun& run : plan.surface) edit_.visit(run, listEach);
    for (const KeyRun& run : plan.inside) {
      edit_.visit(run, [&](KeyRun piece, const Block* block) {
        const bool full = block != nullptr && block->interned && block->low >= 1;
        if (block == nullptr) solidRuns_.push_back(piece);
        if (block != nullptr && !full) listEach(piece, block);
      });
    }
  }

  void compute() {
    parallelFor(work_.size(), 32, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) compute(work_[n]);
    });
  }

  void compute(BlockWork<Side>& work) const {
    alignas(64) float target[Block::kCount];
    solid_->evaluate(Geometry::firstCornerOf(work.key) - solid_->cell, Side, target);
    BlockView view = viewOf(edit_, work, WriteTo::own);
    work.outcome = bozzetto::run(view, FillRule{target, colour_});
  }

  // The empty inside: runs of one interned block.
  void put(DabReport& report) {
    if (solidRuns_.empty()) return;
    const auto full = Block::uniform(1, colour_);
    for (const KeyRun& run : solidRuns_) {
      edit_.replace(run, full);
      report.dirty += std::int64_t{run.length} * Block::kCount;
      report.changed.push_back(run);
    }
    solidRuns_.clear();
  }

  Edit<Block>& edit_;
  std::unique_ptr<Solid> solid_;
  Attributes colour_;
  KeyBox box_, blocks_;
  std::vector<Plan> plans_;
  std::vector<KeyRun> solidRuns_;
  std::vector<BlockWork<Side>> work_;
};

}  // namespace

template <int Side>
DabReport fill(Edit<CornerBlock<Side>>& edit, const FieldScale& scale, const Primitive& primitive,
               Progress& progress) {
  const glm::dvec3 radii = primitive.radii / scale.spacing;
  requireAffordable(radii, Side);
  const Key origin = cellOf(primitive.centre, scale.spacing, "fill centre");
  const auto orientation = glm::mat3_cast(normalisedRotation(primitive.rotation));
  const DabPose pose{origin, relativeTo(origin, primitive.centre, scale.spacing), orientation,
                     radii};
  try {
    return Filler<Side>(edit, primitive, pose).run(progress);
  } catch (...) {
    edit.rollback();
    throw;
  }
}

template DabReport fill(Edit<CornerBlock<1>>&, const FieldScale&, const Primitive&, Progress&);
template DabReport fill(Edit<CornerBlock<8>>&, const FieldScale&, const Primitive&, Progress&);

}  // namespace bozzetto
