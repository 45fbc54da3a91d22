#include "bozzetto/tool/patch.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <vector>

#include "bozzetto/base/error.hpp"
#include "bozzetto/field/block_cache.hpp"
#include "bozzetto/tool/relative.hpp"
#include "bozzetto/tool/sculpture.hpp"

namespace bozzetto {
namespace {

using Block = CornerBlock<8>;
using Geometry = BlockGeometry<8>;

// Corners over the plane, in cells.
class Heights {
 public:
  Heights(const ClayPlane& plane, double spacing)
      : at_(plane.at / spacing), normal_(glm::normalize(plane.normal)) {}
  double operator()(const glm::dvec3& cell) const { return glm::dot(cell - at_, normal_); }

 private:
  glm::dvec3 at_, normal_;
};

// Over the band the plane has no clay; under it all is plane.
constexpr double kBand = 1.5;
// Of density: less is the plane's own roughness, and twice that more surely is no plane.
constexpr double kRough = 0.12;

// The plane's own density p is taken away. Where something stands, density is the larger of both,
// so what is above p is its own; 1 − p closes it where it stood.
float standing(float value, double height) {
  if (height >= kBand) return value;
  const double p = std::clamp(0.5 - height / 2, 0.0, 1.0);
  const double own = std::clamp((double(value) - p - kRough) / (2 * kRough), 0.0, 1.0);
  return float(std::min(double(value), 1 - p) * own);
}

Ref<Block> standingPart(const Block& block, Key key, const Heights& heights) {
  Ref<Block> copy(new Block(block));
  const Key first = Geometry::firstCornerOf(key);
  for (int n = 0; n < Geometry::kCount; ++n) {
    const Key corner = first + Key{n >> 6, n >> 3 & 7, n & 7};
    float& value = copy->value[std::size_t(n)];
    value = standing(value, heights({corner.i, corner.j, corner.k}));
    if (value == 0) copy->attributes[std::size_t(n)] = 0;
  }
  return Block::canonical(std::move(copy));
}

// Seen along an axis: where clay begins in one column after another.
struct Side {
  Axis axis;
  bool fromHigh;
};

// How far into the box clay begins, in cells; nothing where there is none, or at the box's face,
// where it has been cut.
class Columns {
 public:
  Columns(const Clay& clay, const KeyBox& box, Side side)
      : cache_(clay.tree), iso_(clay.scale.iso), box_(box), side_(side) {}

  std::optional<double> depth(Key foot) {
    const int count = box_.high[side_.axis] - box_.low[side_.axis] + 1;
    float before = 0;
    for (int n = 0; n < count; ++n) {
      foot[side_.axis] = side_.fromHigh ? box_.high[side_.axis] - n : box_.low[side_.axis] + n;
      const Block* block = cache_.find(Geometry::blockOf(foot));
      if (block == nullptr) {
        n += cellsLeft(foot[side_.axis]);
        before = 0;
        continue;
      }
      const float value = block->value[std::size_t(Geometry::indexOf(foot))];
      if (value >= iso_) {
        if (n == 0 && value >= 1) return std::nullopt;
        return n - double((value - iso_) / (value - before));
      }
      before = value;
    }
    return std::nullopt;
  }

 private:
  // Corners of the same block that come after this one.
  int cellsLeft(std::int32_t at) const { return side_.fromHigh ? at & 7 : 7 - (at & 7); }

  BlockCache<Block> cache_;
  float iso_;
  KeyBox box_;
  Side side_;
};

// What most columns of a side say.
struct Vote {
  std::size_t columns = 0;
  double depth = 0;
};

Vote voteOf(const std::vector<double>& depths) {
  std::map<long, std::size_t> bins;  // halves of cells
  for (const double depth : depths) ++bins[std::lround(2 * depth)];
  long best = 0;
  for (const auto& [bin, count] : bins)
    if (count > bins[best]) best = bin;
  Vote vote;
  double sum = 0;
  bool something = false;
  for (const double depth : depths) {
    something = something || depth < 0.5 * double(best) - kBand;
    if (std::abs(depth - 0.5 * double(best)) > 0.75) continue;
    sum += depth;
    ++vote.columns;
  }
  if (!something) return {};
  vote.depth = sum / double(vote.columns);
  return vote;
}

// Of one side; no plane is so small that one column in ten misses it.
Vote voteOf(const Clay& clay, const KeyBox& box, Side side) {
  constexpr int kMost = 128;
  const Axis a = side.axis == Axis::x ? Axis::y : Axis::x;
  const Axis b = side.axis == Axis::z ? Axis::y : Axis::z;
  const int stepA = (box.high[a] - box.low[a]) / kMost + 1;
  const int stepB = (box.high[b] - box.low[b]) / kMost + 1;
  Columns columns(clay, box, side);
  std::vector<double> depths;
  std::size_t asked = 0;
  Key foot = box.low;
  for (foot[a] = box.low[a]; foot[a] <= box.high[a]; foot[a] += stepA)
    for (foot[b] = box.low[b]; foot[b] <= box.high[b]; foot[b] += stepB, ++asked)
      if (const auto depth = columns.depth(foot)) depths.push_back(*depth);
  const Vote vote = voteOf(depths);
  return 10 * vote.columns > asked ? vote : Vote{};
}

}  // namespace

Clay standingOn(const Clay& clay, const ClayPlane& plane) {
  const double length = glm::length(plane.normal);
  const double far = glm::length(plane.at);
  if (!std::isfinite(far))
    throw Error("patch: plane at " + toText(plane.at) + " found, a place expected");
  if (!(length > 1e-9) || !std::isfinite(length))
    throw Error("patch: normal " + toText(plane.normal) + " found, a direction expected");
  const Heights heights(plane, clay.scale.spacing);
  const double reach = 3.5 * std::sqrt(3.0);
  Clay part;
  part.scale = clay.scale;
  for (const auto& [key, run] : clay.tree) {
    for (std::int32_t n = 0; n < run.length; ++n) {
      const Key at = key + Key{0, 0, n}, first = Geometry::firstCornerOf(at);
      const double middle = heights(glm::dvec3(first.i, first.j, first.k) + 3.5);
      if (middle + reach <= -1) continue;
      const bool whole = middle - reach >= kBand;
      auto block = whole ? run.block : standingPart(*run.block, at, heights);
      if (block) part.tree.put(at, std::move(block));
    }
  }
  return part;
}

std::optional<ClayPlane> planeUnder(const Clay& clay) {
  const KeyBox box = boundsOf(clay);
  if (box.empty()) return std::nullopt;
  std::optional<ClayPlane> plane;
  std::size_t most = 0;
  for (const Axis axis : kAxes) {
    for (const bool fromHigh : {true, false}) {
      const Vote vote = voteOf(clay, box, {axis, fromHigh});
      if (vote.columns <= most) continue;
      most = vote.columns;
      const int a = index(axis);
      const double height = fromHigh ? box.high[axis] - vote.depth : box.low[axis] + vote.depth;
      plane.emplace();
      plane->at =
          glm::dvec3(box.low.i + box.high.i, box.low.j + box.high.j, box.low.k + box.high.k) *
          (clay.scale.spacing / 2);
      plane->at[a] = height * clay.scale.spacing;
      plane->normal = glm::dvec3(0);
      plane->normal[a] = fromHigh ? 1 : -1;
    }
  }
  return plane;
}

}  // namespace bozzetto
