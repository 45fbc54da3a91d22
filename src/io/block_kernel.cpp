#include "io/block_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace bozzetto {
namespace {

constexpr int kSide = BlockKernel::kSide;
constexpr double kReach = 1;                // half the slope, in cells
constexpr double kFarSquared = 1e30;        // no triangle within the slope
constexpr double kOnSurfaceSquared = 1e-6;  // a thousandth of a cell: no side to speak of
constexpr double kUnclear = 0.25;           // winding numbers this far from whole: a hole is near
constexpr double kJustOutside = 0.499;      // ½ itself is inside
constexpr std::uint32_t kNone = ~0u;
constexpr int kApron = kSide + 3;  // corners of the block and one more on every side

constexpr std::array<int, 3> kApronStrides{kApron * kApron, kApron, 1};

constexpr int cornerIndex(int i, int j, int k) { return (i * kSide + j) * kSide + k; }
constexpr int apronIndex(int i, int j, int k) {
  return ((i + 1) * kApron + j + 1) * kApron + k + 1;
}

double distanceOf(double squared) { return squared < kFarSquared ? std::sqrt(squared) : kReach; }

// First and last corner of a block within reach of [low, high] along one axis.
std::pair<int, int> cornersWithin(double low, double high) {
  const double first = std::max(0.0, std::ceil(low - kReach));
  const double last = std::min(kSide - 1.0, std::floor(high + kReach));
  return {static_cast<int>(std::min<double>(first, kSide)), static_cast<int>(std::max(last, -1.0))};
}

}  // namespace

glm::dvec3 BlockKernel::placeOf(int corner) const {
  return origin_ + glm::dvec3(corner / (kSide * kSide), corner / kSide % kSide, corner % kSide);
}

bool BlockKernel::fill(const BlockTask& task, CornerBlock<8>& out) {
  origin_ = glm::dvec3(task.block.i, task.block.j, task.block.k) * double(kSide);
  findNearest(task, Sheets::all);
  toHole_.fill(kReach);
  const bool sheets = task.kind == BlockKind::sheets || task.kind == BlockKind::rim;
  if (!sheets || !findInsideByRegions(task.kind)) findInsideEverywhere(task.kind);
  // Where bodies overlap, triangles inside the clay are not its surface.
  if (contradictsWinding()) {
    findInsideOnTriangles();
    findNearest(task, Sheets::surfaceOnly);
  }

  bool clay = false;
  for (int corner = 0; corner < kCount; ++corner) {
    const float value = valueAt(corner);
    out.value[corner] = value;
    out.attributes[corner] = value > 0 ? packAttributes(colourAt(corner)) : 0;
    clay = clay || value > 0;
  }
  return clay;
}

void BlockKernel::findNearest(const BlockTask& task, Sheets sheets) {
  squared_.fill(kFarSquared);
  nearest_.fill(kNone);
  for (const auto& pair : task.triangles) visitTriangle(pair.triangle, sheets);
}

void BlockKernel::visitTriangle(std::uint32_t number, Sheets sheets) {
  const auto& t = grid_.mesh.triangles[number];
  const auto &a = grid_.mesh.positions[t[0]], &b = grid_.mesh.positions[t[1]],
             &c = grid_.mesh.positions[t[2]];
  const auto low = glm::min(glm::min(a, b), c) - origin_;
  const auto high = glm::max(glm::max(a, b), c) - origin_;
  const auto [i0, i1] = cornersWithin(low.x, high.x);
  const auto [j0, j1] = cornersWithin(low.y, high.y);
  const auto [k0, k1] = cornersWithin(low.z, high.z);
  const auto& triangle = grid_.triangles[number];
  for (int i = i0; i <= i1; ++i) {
    for (int j = j0; j <= j1; ++j) {
      for (int k = k0; k <= k1; ++k) {
        const int corner = cornerIndex(i, j, k);
        const auto found = triangle.nearestTo(origin_ + glm::dvec3(i, j, k));
        if (!(found.squared < squared_[corner]) || found.squared >= kReach * kReach) continue;
        if (sheets == Sheets::surfaceOnly && !isSurface(triangle, found)) continue;
        squared_[corner] = found.squared;
        nearest_[corner] = number;
        u_[corner] = static_cast<float>(found.u);
        v_[corner] = static_cast<float>(found.v);
      }
    }
  }
}

// A thousandth of a cell in front of it; 1 where it has no front.
double BlockKernel::windingBefore(const DistanceTriangle& triangle,
                                  const NearestPoint& nearest) const {
  const auto normal = triangle.normal();
  const double length = glm::length(normal);
  if (!(length > 0)) return 1;
  return winding_.at(triangle.at(nearest.u, nearest.v) + normal * (1e-3 / length));
}

// Crossing a triangle from front to back adds 1 to the winding number: the surface is where that
// passes ½.
bool BlockKernel::isSurface(const DistanceTriangle& triangle, const NearestPoint& nearest) const {
  const double winding = windingBefore(triangle, nearest);
  return winding > -0.5 && winding <= 0.5;
}

// On a triangle the winding number may be anything; on one that is no surface, what is before it
// goes on behind it.
void BlockKernel::findInsideOnTriangles() {
  for (int corner = 0; corner < kCount; ++corner) {
    if (squared_[corner] >= kOnSurfaceSquared) continue;
    const NearestPoint nearest{squared_[corner], u_[corner], v_[corner]};
    const double winding = windingBefore(grid_.triangles[nearest_[corner]], nearest);
    inside_[corner] = winding > 0.5 ? kInside : kOutside;
  }
}

// Two corners are parted by a triangle only if it passes between them, so their distances to it
// add up to at most the distance between them. Regions of corners that nothing parts are on one
// side; the corner farthest from all triangles speaks for them. False where a hole is near.
bool BlockKernel::findInsideByRegions(BlockKind kind) {
  seen_.fill(0);
  for (int start = 0; start < kCount; ++start) {
    if (seen_[start] != 0) continue;
    growRegion(start);
    const int speaker = *std::max_element(region_.begin(), region_.end(), [&](int a, int b) {
      return squared_[a] != squared_[b] ? squared_[a] < squared_[b] : a > b;
    });
    const double winding = winding_.at(placeOf(speaker));
    // Corners on a triangle have no side to speak of.
    const bool open = !grid_.openEdges.empty() && squared_[speaker] > kOnSurfaceSquared;
    if (open && !regionAgrees(kind, winding)) return false;
    for (const int corner : region_) inside_[corner] = winding > 0.5 ? kInside : kOutside;
  }
  return true;
}

// Clearly in or clearly out, and beside open edges so do the region's ends in 14 directions.
bool BlockKernel::regionAgrees(BlockKind kind, double winding) const {
  const double side = std::round(winding);
  if (std::abs(winding - side) > kUnclear) return false;
  if (kind == BlockKind::sheets) return true;
  static const std::array<glm::dvec3, 7> directions{
      glm::dvec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}};
  for (const auto& direction : directions) {
    const auto [first, last] =
        std::minmax_element(region_.begin(), region_.end(), [&](int a, int b) {
          return glm::dot(direction, placeOf(a)) < glm::dot(direction, placeOf(b));
        });
    for (const int end : {*first, *last}) {
      if (squared_[end] <= kOnSurfaceSquared) continue;
      if (std::abs(winding_.at(placeOf(end)) - side) > kUnclear) return false;
    }
  }
  return true;
}

void BlockKernel::growRegion(int start) {
  static const std::array<double, 4> lengths{0, 1, std::sqrt(2.0), std::sqrt(3.0)};
  region_.assign(1, start);
  seen_[start] = 1;
  for (std::size_t done = 0; done < region_.size(); ++done) {
    const int corner = region_[done];
    const int i = corner / (kSide * kSide), j = corner / kSide % kSide, k = corner % kSide;
    const double own = distanceOf(squared_[corner]);
    for (int di = -(i > 0); di <= (i < kSide - 1); ++di) {
      for (int dj = -(j > 0); dj <= (j < kSide - 1); ++dj) {
        for (int dk = -(k > 0); dk <= (k < kSide - 1); ++dk) {
          const int other = cornerIndex(i + di, j + dj, k + dk);
          if (seen_[other] != 0) continue;
          const double length = lengths[std::abs(di) + std::abs(dj) + std::abs(dk)];
          if (own + distanceOf(squared_[other]) <= length * (1 + 1e-9)) continue;
          seen_[other] = 1;
          region_.push_back(other);
        }
      }
    }
  }
}

// A corner that is inside alone would be a crumb of less than a cell at the rim of a hole.
bool BlockKernel::hasInsideNeighbour(int at) const {
  return std::any_of(kApronStrides.begin(), kApronStrides.end(), [&](int stride) {
    return winds_[at - stride] > 0.5f || winds_[at + stride] > 0.5f;
  });
}

void BlockKernel::sampleWinding(int step) {
  winds_.resize(kApron * kApron * kApron);
  for (int i = -1; i < kSide + step; i += step) {
    for (int j = -1; j < kSide + step; j += step) {
      for (int k = -1; k < kSide + step; k += step) {
        winds_[apronIndex(i, j, k)] =
            static_cast<float>(winding_.at(origin_ + glm::dvec3(i, j, k)));
      }
    }
  }
}

// Fills in every other corner: along i between samples, then along j, then along k.
void BlockKernel::interpolateWinding() {
  for (const int stride : kApronStrides) {
    for (int at = 0; at < kApron * kApron * kApron; ++at) {
      if (at / stride % kApron % 2 == 0) continue;
      winds_[at] = (winds_[at - stride] + winds_[at + stride]) / 2;
    }
  }
}

// Winding numbers of the block and its apron; where they pass ½ smoothly, without a triangle, the
// distance to that level is (w - ½)/|∇w|.
void BlockKernel::findInsideEverywhere(BlockKind kind) {
  sampleWinding(kind == BlockKind::level ? 2 : 1);
  if (kind == BlockKind::level) interpolateWinding();
  for (int corner = 0; corner < kCount; ++corner) {
    const int i = corner / (kSide * kSide), j = corner / kSide % kSide, k = corner % kSide;
    const int at = apronIndex(i, j, k);
    const double own = winds_[at];
    double slopeSquared = 0;
    for (const int stride : kApronStrides) {
      // A triangle between two corners makes a jump of 1; such steps say nothing about the slope.
      const double up = winds_[at + stride] - own, down = own - winds_[at - stride];
      const bool upSmooth = std::abs(up) < 0.5, downSmooth = std::abs(down) < 0.5;
      const double slope = upSmooth && downSmooth ? (up + down) / 2
                           : upSmooth             ? up
                           : downSmooth           ? down
                                                  : 0;
      slopeSquared += slope * slope;
    }
    inside_[corner] = own <= 0.5 ? kOutside : hasInsideNeighbour(at) ? kInside : kCrumb;
    const double distance = std::abs(own - 0.5);
    if (distance * distance < slopeSquared) toHole_[corner] = distance / std::sqrt(slopeSquared);
  }
}

// Whether the corners before the triangle belong to the next block.
bool BlockKernel::frontLiesBeyond(int corner, const DistanceTriangle& triangle) const {
  const glm::dvec3 normal = triangle.normal(), size = glm::abs(normal);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const double at = (placeOf(corner) - origin_)[axis];
  return normal[axis] > 0 ? at == kSide - 1 : at == 0;
}

// A corner in front of its nearest triangle is outside and one behind it inside, unless bodies
// overlap or walls are double. On a triangle there is no side; where the block has no corners
// before it either, the triangle itself is asked.
bool BlockKernel::contradictsWinding() const {
  for (int corner = 0; corner < kCount; ++corner) {
    if (nearest_[corner] == kNone) continue;
    const NearestPoint nearest{squared_[corner], u_[corner], v_[corner]};
    if (!nearest.onFace()) continue;
    const DistanceTriangle& triangle = grid_.triangles[nearest_[corner]];
    if (nearest.squared < kOnSurfaceSquared) {
      if (frontLiesBeyond(corner, triangle) && !isSurface(triangle, nearest)) return true;
      continue;
    }
    const bool front = triangle.isFrontOf(placeOf(corner));
    if (front == (inside_[corner] == kInside)) return true;
  }
  return false;
}

float BlockKernel::valueAt(int corner) const {
  const double distance = std::min(distanceOf(squared_[corner]), toHole_[corner]);
  const double half = std::min(distance / (2 * kReach), 0.5);
  if (inside_[corner] == kInside) return static_cast<float>(0.5 + half);
  return static_cast<float>(inside_[corner] == kCrumb ? std::min(0.5 - half, kJustOutside)
                                                      : 0.5 - half);
}

Colour BlockKernel::colourAt(int corner) const {
  if (nearest_[corner] == kNone || grid_.mesh.colours.empty()) return colour_;
  const auto& t = grid_.mesh.triangles[nearest_[corner]];
  const auto &a = grid_.mesh.colours[t[0]], &b = grid_.mesh.colours[t[1]],
             &c = grid_.mesh.colours[t[2]];
  const float u = u_[corner], v = v_[corner];
  const auto mix = [&](std::uint8_t x, std::uint8_t y, std::uint8_t z) {
    const float blend = (1 - u - v) * float(x) + u * float(y) + v * float(z);
    return static_cast<std::uint8_t>(std::clamp(blend + 0.5f, 0.0f, 255.0f));
  };
  return {mix(a.r, b.r, c.r), mix(a.g, b.g, c.g), mix(a.b, b.b, c.b)};
}

}  // namespace bozzetto
