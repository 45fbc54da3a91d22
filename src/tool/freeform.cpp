#include "tool/freeform.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <span>

#include "tool/corner_loop.hpp"
#include "tool/turned_avx2.hpp"

namespace bozzetto {
namespace {

constexpr double kOne = 1 << kFractionBits;
constexpr double kRounding = 1.0 / 16;  // of positions over a whole tool: cells, generously

bool oneByOne(const FixedFrame& frame) { return frame.step[2][2] == 1 << kFractionBits; }

#if defined(__x86_64__)
BOZZETTO_TARGET_AVX2 void alignedAvx2(const TilePatch& patch, float* result) {
  if (oneByOne(patch.frame)) return oneByOneAvx2(patch, result);
  if (patch.box != nullptr) return scaledAvx2(patch, result);
  alignedBody<8>(patch, result);
}
#endif

bool aligned(const FixedFrame& frame) {
  for (const Axis grid : kAxes)
    for (const Axis axis : kAxes)
      if (grid != axis && frame.step[index(grid)][index(axis)] != 0) return false;
  return true;
}

void reconstruct(const TilePatch& patch, int side, float* result) {
  const bool straight = aligned(patch.frame);
  if (side == 1) return straight ? alignedBody<1>(patch, result) : turnedBody<1>(patch, result);
#if defined(__x86_64__)
  if (hasAvx2()) return straight ? alignedAvx2(patch, result) : turnedAvx2(patch, result);
#endif
  straight ? alignedBody<8>(patch, result) : turnedBody<8>(patch, result);
}

// Plain kernels of straight tools read tiles: whole planes of them at once.
bool readsBox(const FixedFrame& frame, int side) {
  return !aligned(frame) || (side == 8 && hasAvx2());
}

class FreeformPotential final : public Potential {
 public:
  FreeformPotential(std::shared_ptr<const Sculpture> sculpture, const glm::dvec3& radii)
      : sculpture_(std::move(sculpture)) {
    const int level = levelFor(*sculpture_, radii);
    level_ = &sculpture_->level(level);
    const glm::dvec3 centre = std::ldexp(1.0, -level) * sculpture_->centre();
    base_ = baseOf(*sculpture_, level);
    centre_ = centre - glm::dvec3(base_.i, base_.j, base_.k);
    half_ = std::ldexp(1.0, -level) * sculpture_->halfExtents();
    for (const Axis axis : kAxes) {
      const auto a = index(axis);
      const double middle = centre[a];
      const double wide =
          1 + std::max(level_->bounds.high[axis] - middle, middle - level_->bounds.low[axis]);
      reach_[a] = (std::max(wide - half_[a], 0.0) + kRounding) * radii[a] / half_[a];
    }
  }

  glm::dvec3 reach() const override { return reach_; }

  LocalFrame frame(const DabPose& pose) const override {
    LocalFrame frame = localFrame(pose);
    const Key cell = frame.cell - pose.origin;
    const glm::dvec3 fraction = pose.position - glm::dvec3(cell.i, cell.j, cell.k);
    for (int axis = 0; axis < 3; ++axis) {
      double offset = 0;
      for (int grid = 0; grid < 3; ++grid) {
        const double step = pose.orientation[axis][grid] * half_[axis] / pose.radii[axis];
        frame.fixed.step[grid][axis] = static_cast<std::int32_t>(std::llround(kOne * step));
        offset -= fraction[grid] * step;
      }
      frame.fixed.first[axis] = static_cast<std::int32_t>(std::llround(kOne * centre_[axis]) +
                                                          std::llround(kOne * offset));
    }
    return frame;
  }

  bool misses(const LocalFrame& frame, Key low, Key high) const override {
    const KeyBox read = cornersRead(frame.fixed, low, high);
    for (const Axis axis : kAxes) {
      if (read.high[axis] < level_->bounds.low[axis]) return true;
      if (read.low[axis] > level_->bounds.high[axis]) return true;
    }
    if (high.k - low.k > 7) return false;  // a column: too many blocks to look at
    const ToolBox& box = level_->box();
    if (box.value.empty()) return !level_->blocks.any(read);
    return box.bricks.kindOf(read.low - box.low, read.high - box.low) == ToolKind::empty;
  }

  void evaluate(const LocalFrame& frame, Key first, int side, float* potential) const override {
    if (readsBox(frame.fixed, side) && !level_->box().value.empty())
      return evaluateBoxed(frame, first, side, potential);
    ToolTile tile;
    gatherTile(frame, first, side, tile);
    if (tile.kind != ToolKind::varied) return fillAlike(tile.kind, side, potential);
    reconstruct({frame.fixed, first, base_, tile.low, tile.wide, tile.value.data()}, side,
                potential);
  }

  bool coloured() const override { return true; }

  void evaluateColours(const LocalFrame& frame, Key first, int side,
                       Attributes* colours) const override {
    const int count = side * side * side;
    if (!sculpture_->colours().many) {
      std::fill_n(colours, count, packAttributes(sculpture_->colours().mean));
      return;
    }
    ToolTile tile;
    gatherTile(frame, first, side, tile);
    alignas(64) std::array<Attributes, ToolTile::kCorners> attributes;
    Attributes only = 0;
    if (!gatherColours(level_->blocks, tile, attributes.data(), only)) {
      std::fill_n(colours, count, only);
      return;
    }
    if (tile.kind == ToolKind::full) tile.value.fill(1);
    mixColours({frame.fixed, first, base_, tile.low, tile.wide, nullptr}, tile, attributes.data(),
               {colours, static_cast<std::size_t>(side * side * side)});
  }

 private:
  // The tool's corners that reconstruction reads for the clay's corners low … high.
  KeyBox cornersRead(const FixedFrame& frame, Key low, Key high) const {
    KeyBox read;
    for (const Axis axis : kAxes) {
      const auto a = static_cast<std::size_t>(index(axis));
      std::int64_t least = frame.first[a], most = least;
      for (const Axis grid : kAxes) {
        const std::int64_t step = frame.step[static_cast<std::size_t>(index(grid))][a];
        least += std::min(step * low[grid], step * high[grid]);
        most += std::max(step * low[grid], step * high[grid]);
      }
      read.low[axis] = base_[axis] + static_cast<std::int32_t>(least >> kFractionBits);
      read.high[axis] = base_[axis] + static_cast<std::int32_t>(most >> kFractionBits) + 1;
    }
    return read;
  }

  static void fillAlike(ToolKind kind, int side, float* potential) {
    std::fill_n(potential, side * side * side, kind == ToolKind::full ? 1.0f : 0.0f);
  }

  KeyBox cornersRead(const LocalFrame& frame, Key first, int side) const {
    return cornersRead(frame.fixed, first, first + Key{side - 1, side - 1, side - 1});
  }

  void evaluateBoxed(const LocalFrame& frame, Key first, int side, float* potential) const {
    const KeyBox read = cornersRead(frame, first, side);
    const ToolBox& box = level_->box();
    const ToolKind kind = box.bricks.kindOf(read.low - box.low, read.high - box.low);
    if (kind != ToolKind::varied) return fillAlike(kind, side, potential);
    reconstruct({frame.fixed, first, base_, box.low, box.wide, box.value.data(), &box}, side,
                potential);
  }

  void gatherTile(const LocalFrame& frame, Key first, int side, ToolTile& tile) const {
    const KeyBox read = cornersRead(frame, first, side);
    gather(level_->blocks, read.low, read.high, tile);
  }

  // Means of the eight colours weighted by closeness and density.
  static void mixColours(TilePatch patch, const ToolTile& tile, const Attributes* attributes,
                         std::span<Attributes> colours) {
    const int side = colours.size() == 1 ? 1 : 8;
    const auto corners = static_cast<std::size_t>(tile.wide[0] * tile.wide[1] * tile.wide[2]);
    alignas(64) std::array<float, ToolTile::kCorners> premultiplied;
    alignas(64) float density[512], channel[512];
    patch.value = tile.value.data();
    reconstruct(patch, side, density);
    std::ranges::fill(colours, 0);
    for (int shift = 0; shift < 24; shift += 8) {
      for (std::size_t n = 0; n < corners; ++n) {
        const auto level = static_cast<float>(static_cast<int>(attributes[n] >> shift & 255));
        premultiplied[n] = tile.value[n] * level;
      }
      patch.value = premultiplied.data();
      reconstruct(patch, side, channel);
      for (std::size_t n = 0; n < colours.size(); ++n) {
        const float mean = density[n] > 0 ? channel[n] / density[n] : 0;
        colours[n] |= static_cast<Attributes>(nearest(mean) & 255) << shift;
      }
    }
  }

  std::shared_ptr<const Sculpture> sculpture_;
  const SculptureLevel* level_;
  Key base_;           // the tool's corner at position 0
  glm::dvec3 centre_;  // of its box, cells from base
  glm::dvec3 half_;
  glm::dvec3 reach_{0};  // pre-filtering widens
};

}  // namespace

double minification(const Sculpture& sculpture, const glm::dvec3& radii) {
  const glm::dvec3 half = sculpture.halfExtents();
  return std::max({half.x / radii.x, half.y / radii.y, half.z / radii.z});
}

int levelFor(const Sculpture& sculpture, const glm::dvec3& radii) {
  const double ratio = minification(sculpture, radii);
  return std::clamp(static_cast<int>(std::ceil(std::log2(ratio) - 0.5)), 0, Sculpture::kLevels);
}

Key baseOf(const Sculpture& sculpture, int level) {
  const glm::dvec3 centre = std::ldexp(1.0, -level) * sculpture.centre();
  Key base;
  for (const Axis axis : kAxes)
    base[axis] = static_cast<std::int32_t>(std::floor(centre[index(axis)]));
  return base;
}

std::shared_ptr<const DistanceField> SculptureLevel::outside(float iso, int reach) const {
  const std::lock_guard lock(making_);
  auto& made = outside_[{iso, reach}];
  if (made == nullptr) made = std::make_shared<DistanceField>(clay, bounds, iso, reach);
  return made;
}

std::shared_ptr<const HandleRoom> SculptureLevel::handle(const glm::dvec3& contact,
                                                         int reach) const {
  const std::lock_guard lock(making_);
  auto& made = handles_[{contact.x, contact.y, contact.z, double(reach)}];
  if (made == nullptr) made = std::make_shared<HandleRoom>(clay, bounds, contact, reach);
  return made;
}

const ToolBox& SculptureLevel::box() const {
  std::call_once(boxed_, [this] { box_ = std::make_unique<const ToolBox>(clay, bounds); });
  return *box_;
}

void putOnPivot(const Sculpture& sculpture, DabPose& pose) {
  pose.position -= pose.orientation * (sculpture.pivot() * pose.radii / sculpture.halfExtents());
}

namespace {

// Its pivot lies on its contact side: nothing is two cells on, or, of what is flat, no clay, though
// edges that were smoothed fade farther.
bool onlyTouches(const Sculpture& sculpture) {
  const glm::dvec3 contact = sculpture.contact(), all = sculpture.halfExtents() - 1.0;
  const double half = glm::dot(glm::abs(contact), all);
  const double beyond = half - glm::dot(contact, sculpture.pivot());
  if (beyond <= 2) return true;
  if (beyond > half / 2 || half > 1.01 * std::min({all.x, all.y, all.z})) return false;
  const glm::dvec3 at = glm::round(sculpture.centre() + sculpture.pivot() + 2.0 * contact);
  return sculpture.clay().value({int(at.x), int(at.y), int(at.z)}) < 0.5f;
}

}  // namespace

double printDepth(const Sculpture& sculpture, const glm::dvec3& radii) {
  if (!onlyTouches(sculpture)) return 0;
  const glm::dvec3 along = glm::abs(sculpture.contact());
  const glm::dvec3 own = sculpture.halfExtents() - 1.0;
  const glm::dvec3 half = own * radii / sculpture.halfExtents();
  const double most = std::max({along.x, along.y, along.z}), height = 2 * glm::dot(along, half);
  double width = height * 4;
  for (int axis = 0; axis < 3; ++axis)
    if (along[axis] < most) width = std::min(width, 2 * half[axis]);
  return std::max(std::min(height / 2, width / 4), std::min(height, kSmallestToolCells));
}

std::unique_ptr<Potential> makeFreeform(std::shared_ptr<const Sculpture> sculpture,
                                        const glm::dvec3& radiiCells) {
  return std::make_unique<FreeformPotential>(std::move(sculpture), radiiCells);
}

}  // namespace bozzetto
