#include "tool/sculpted_solid.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "bozzetto/base/parallel.hpp"
#include "bozzetto/field/sampler.hpp"
#include "bozzetto/tool/dab.hpp"
#include "bozzetto/tool/solid.hpp"
#include "tool/density_grid.hpp"
#include "tool/eikonal.hpp"

namespace bozzetto {
namespace {

constexpr double kLeastCore = 0.25;  // cells
constexpr double kMostNodes = 160, kMargin = 3;
constexpr int kOrders = 16;  // distances round corners of the tool come right in the second round

}  // namespace

SculptedDistance::SculptedDistance(const Sculpture& sculpture) {
  const glm::dvec3 half = sculpture.halfExtents() + 1.0;
  spacing_ = std::max(1.0, 2 * std::max({half.x, half.y, half.z}) / (kMostNodes - 2 * kMargin));
  low_ = -half - kMargin * spacing_;
  for (int axis = 0; axis < 3; ++axis)
    size_[std::size_t(axis)] =
        static_cast<int>(std::ceil(2 * half[axis] / spacing_ + 2 * kMargin)) + 1;
  find(densities(sculpture), sculpture.scale().iso);
}

std::vector<float> SculptedDistance::densities(const Sculpture& sculpture) const {
  std::vector<float> density(index(size_[0], 0, 0));
  const glm::dvec3 origin = sculpture.centre() + low_;
  if (spacing_ == 1) {
    // Nodes are corners.
    const Key low{int(std::lround(origin.x)), int(std::lround(origin.y)),
                  int(std::lround(origin.z))};
    readDensities(sculpture.clay(), low, size_, density);
    return density;
  }
  parallelFor(std::size_t(size_[0]), 4, [&](std::size_t begin, std::size_t end) {
    FieldSampler<8> sampler(sculpture.clay());
    for (int i = int(begin); i < int(end); ++i)
      for (int j = 0; j < size_[1]; ++j)
        for (int k = 0; k < size_[2]; ++k)
          density[index(i, j, k)] =
              sampler.value(cellPoint({}, origin + spacing_ * glm::dvec3(i, j, k)));
  });
  return density;
}

// Where the surface crosses an edge of the grid, its nodes know their distance along that edge; by
// the slope across, an estimate of the nearest one. The others follow from them.
void SculptedDistance::find(const std::vector<float>& density, float iso) {
  distance_.assign(density.size(), kFarAway);
  std::vector<std::uint8_t> known(density.size(), 0);
  const std::ptrdiff_t steps[3] = {std::ptrdiff_t{size_[1]} * size_[2], size_[2], 1};
  for (int i = 1; i + 1 < size_[0]; ++i)
    for (int j = 1; j + 1 < size_[1]; ++j)
      for (int k = 1; k + 1 < size_[2]; ++k) {
        const auto at = static_cast<std::ptrdiff_t>(index(i, j, k));
        float sum = 0;
        for (const std::ptrdiff_t step : steps) {
          float nearest = kFarAway;
          for (const std::ptrdiff_t way : {step, -step})
            if ((density[at + way] >= iso) != (density[at] >= iso))
              nearest = std::min(nearest, (iso - density[at]) / (density[at + way] - density[at]));
          if (nearest < kFarAway) sum += 1 / std::max(1e-6f, nearest * nearest);
        }
        if (sum <= 0) continue;
        distance_[at] = 1 / std::sqrt(sum);
        known[at] = 1;
      }
  sweepDistances(size_, known, kOrders, distance_);
  for (std::size_t n = 0; n < density.size(); ++n)
    if (density[n] >= iso) distance_[n] = -distance_[n];
  findDepths();
}

void SculptedDistance::findDepths() {
  double sum = 0, count = 0;
  for (const float distance : distance_) {
    if (distance >= 0) continue;
    const double depth = -static_cast<double>(distance) * spacing_;
    deepest_ = std::max(deepest_, depth);
    sum += depth, ++count;
  }
  if (count > 0) meanDepth_ = sum / count;
}

double SculptedDistance::at(const glm::dvec3& place) const {
  const glm::dvec3 p = (place - low_) / spacing_;
  const glm::dvec3 last(size_[0] - 1, size_[1] - 1, size_[2] - 1);
  const glm::dvec3 inside = glm::clamp(p, glm::dvec3(0), last);
  const glm::dvec3 base = glm::min(glm::floor(inside), last - 1.0), f = inside - base;
  const int i = int(base.x), j = int(base.y), k = int(base.z);
  double sum = 0;
  for (int c = 0; c < 8; ++c) {
    const int di = c >> 2, dj = c >> 1 & 1, dk = c & 1;
    const double weight =
        (di != 0 ? f.x : 1 - f.x) * (dj != 0 ? f.y : 1 - f.y) * (dk != 0 ? f.z : 1 - f.z);
    sum += weight * static_cast<double>(distance_[index(i + di, j + dj, k + dk)]);
  }
  return (sum + glm::length(p - inside)) * spacing_;
}

namespace {

class SculptedSolid final : public Solid {
 public:
  SculptedSolid(std::shared_ptr<const Sculpture> sculpture, const DabPose& pose)
      : sculpture_(std::move(sculpture)), distance_(&sculpture_->distance()) {
    const glm::dvec3 scale = pose.radii / sculpture_->halfExtents();
    cell = localFrame(pose).cell;
    const Key local = cell - pose.origin;
    centre_ = pose.position - glm::dvec3(local.i, local.j, local.k);
    toTool_ = glm::transpose(pose.orientation);
    for (int axis = 0; axis < 3; ++axis)
      for (int column = 0; column < 3; ++column) toTool_[column][axis] /= scale[axis];
    cells_ = std::min({scale.x, scale.y, scale.z});
  }

  void evaluate(Key first, int side, float* value) const override {
    for (int n = 0; n < side * side * side; ++n) {
      const Key at = first + Key{n / (side * side), n / side % side, n % side};
      const double d = distance(glm::dvec3(at.i, at.j, at.k));
      value[n] = static_cast<float>(std::clamp(0.5 - 0.5 * d, 0.0, 1.0));
    }
  }
  double distance(const glm::dvec3& position) const override {
    return distance_->at(toTool_ * (position - centre_)) * cells_;
  }

 private:
  std::shared_ptr<const Sculpture> sculpture_;
  const SculptedDistance* distance_;
  glm::dvec3 centre_{0};  // from `cell`
  glm::dmat3 toTool_{1};
  double cells_ = 1;  // of the clay in one of the tool
};

}  // namespace

double coreDepth(const Sculpture& sculpture, const DabPose& pose) {
  const glm::dvec3 scale = pose.radii / sculpture.halfExtents();
  const SculptedDistance& distance = sculpture.distance();
  const double depth = std::min(distance.deepest(), 3 * distance.meanDepth());
  return std::max(kLeastCore, depth * std::min({scale.x, scale.y, scale.z}));
}

std::unique_ptr<Solid> makeSolid(std::shared_ptr<const Sculpture> sculpture, const DabPose& pose) {
  return std::make_unique<SculptedSolid>(std::move(sculpture), pose);
}

}  // namespace bozzetto
