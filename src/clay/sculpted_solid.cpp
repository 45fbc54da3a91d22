#include "clay/sculpted_solid.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "bozzetto/field/sampler.hpp"
#include "bozzetto/tool/dab.hpp"

namespace bozzetto::clay {
namespace {

constexpr double kMostNodes = 160, kMargin = 3;
constexpr float kUnknown = 1e6f;

}  // namespace

std::size_t SculptedDistance::index(Node n) const {
  return (static_cast<std::size_t>(n.i) * size_.j + n.j) * size_.k + n.k;
}

SculptedDistance::SculptedDistance(const Sculpture& sculpture) {
  const glm::dvec3 half = sculpture.halfExtents() + 1.0;
  spacing_ = std::max(1.0, 2 * std::max({half.x, half.y, half.z}) / (kMostNodes - 2 * kMargin));
  low_ = -half - kMargin * spacing_;
  const auto nodes = [&](double extent) {
    return static_cast<std::int32_t>(std::ceil(2 * extent / spacing_ + 2 * kMargin)) + 1;
  };
  size_ = {nodes(half.x), nodes(half.y), nodes(half.z)};
  sample(sculpture);
  sweep();
}

void SculptedDistance::sample(const Sculpture& sculpture) {
  std::vector<float> density(static_cast<std::size_t>(size_.i) * size_.j * size_.k);
  FieldSampler<8> sampler(sculpture.clay());
  const glm::dvec3 origin = sculpture.centre() + low_;
  for (Node n{0, 0, 0}; n.i < size_.i; ++n.i)
    for (n.j = 0; n.j < size_.j; ++n.j)
      for (n.k = 0; n.k < size_.k; ++n.k)
        density[index(n)] =
            sampler.value(cellPoint({}, origin + spacing_ * glm::dvec3(n.i, n.j, n.k)));
  seed(density, sculpture.scale().iso);
}

// Where the surface crosses an edge of the grid, its nodes know their distance along that edge; by
// the slope across, an estimate of the nearest one.
void SculptedDistance::seed(const std::vector<float>& density, float iso) {
  distance_.assign(density.size(), 0);
  near_.assign(density.size(), false);
  const std::ptrdiff_t steps[3] = {std::ptrdiff_t{size_.j} * size_.k, size_.k, 1};
  for (Node n{0, 0, 0}; n.i < size_.i; ++n.i)
    for (n.j = 0; n.j < size_.j; ++n.j)
      for (n.k = 0; n.k < size_.k; ++n.k) {
        const auto at = static_cast<std::ptrdiff_t>(index(n));
        const float side = density[at] >= iso ? -1.0f : 1.0f;
        distance_[at] = side * kUnknown;
        const bool border = n.i == 0 || n.j == 0 || n.k == 0 || n.i + 1 == size_.i ||
                            n.j + 1 == size_.j || n.k + 1 == size_.k;
        if (border) continue;
        float sum = 0;
        for (const std::ptrdiff_t step : steps) {
          float nearest = kUnknown;
          for (const std::ptrdiff_t way : {step, -step})
            if ((density[at + way] >= iso) != (density[at] >= iso))
              nearest = std::min(nearest, (iso - density[at]) / (density[at + way] - density[at]));
          if (nearest < kUnknown) sum += 1 / std::max(1e-6f, nearest * nearest);
        }
        if (sum <= 0) continue;
        distance_[at] = side / std::sqrt(sum);
        near_[at] = true;
      }
}

// |∇d| = 1 upwind (Zhao 2005): from the nearer neighbour on each axis.
float SculptedDistance::solve(Node n) const {
  const auto nearer = [&](Node a, bool aIn, Node b, bool bIn) {
    return std::min(aIn ? std::abs(distance_[index(a)]) : kUnknown,
                    bIn ? std::abs(distance_[index(b)]) : kUnknown);
  };
  float a[3] = {nearer({n.i - 1, n.j, n.k}, n.i > 0, {n.i + 1, n.j, n.k}, n.i + 1 < size_.i),
                nearer({n.i, n.j - 1, n.k}, n.j > 0, {n.i, n.j + 1, n.k}, n.j + 1 < size_.j),
                nearer({n.i, n.j, n.k - 1}, n.k > 0, {n.i, n.j, n.k + 1}, n.k + 1 < size_.k)};
  std::sort(a, a + 3);
  float d = a[0] + 1;
  if (d <= a[1]) return d;
  d = 0.5f * (a[0] + a[1] + std::sqrt(std::max(0.0f, 2 - (a[0] - a[1]) * (a[0] - a[1]))));
  if (d <= a[2]) return d;
  const float sum = a[0] + a[1] + a[2], squares = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
  return (sum + std::sqrt(std::max(0.0f, sum * sum - 3 * (squares - 1)))) / 3;
}

// Eight orders, twice: distances round corners of the tool come right in the second round.
void SculptedDistance::sweep() {
  for (int order = 0; order < 16; ++order) {
    const auto place = [&](std::int32_t n, std::int32_t count, int bit) {
      return (order >> bit & 1) != 0 ? count - 1 - n : n;
    };
    for (std::int32_t i = 0; i < size_.i; ++i)
      for (std::int32_t j = 0; j < size_.j; ++j)
        for (std::int32_t k = 0; k < size_.k; ++k) {
          const Node n{place(i, size_.i, 0), place(j, size_.j, 1), place(k, size_.k, 2)};
          const std::size_t at = index(n);
          if (near_[at]) continue;
          const float d = solve(n);
          if (d < std::abs(distance_[at])) distance_[at] = std::copysign(d, distance_[at]);
        }
  }
}

double SculptedDistance::at(const glm::dvec3& place) const {
  const glm::dvec3 p = (place - low_) / spacing_;
  const glm::dvec3 last(size_.i - 1, size_.j - 1, size_.k - 1);
  const glm::dvec3 inside = glm::clamp(p, glm::dvec3(0), last);
  const glm::dvec3 base = glm::min(glm::floor(inside), last - 1.0), f = inside - base;
  const Node n{static_cast<std::int32_t>(base.x), static_cast<std::int32_t>(base.y),
               static_cast<std::int32_t>(base.z)};
  double sum = 0;
  for (std::int32_t c = 0; c < 8; ++c) {
    const std::int32_t di = c >> 2, dj = c >> 1 & 1, dk = c & 1;
    const double weight =
        (di != 0 ? f.x : 1 - f.x) * (dj != 0 ? f.y : 1 - f.y) * (dk != 0 ? f.z : 1 - f.z);
    sum += weight * static_cast<double>(distance_[index({n.i + di, n.j + dj, n.k + dk})]);
  }
  return (sum + glm::length(p - inside)) * spacing_;
}

namespace {

class SculptedSolid final : public Solid {
 public:
  SculptedSolid(std::shared_ptr<const SculptedDistance> distance, const Sculpture& sculpture,
                const DabPose& pose)
      : distance_(std::move(distance)) {
    const glm::dvec3 scale = pose.radii / sculpture.halfExtents();
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
  std::shared_ptr<const SculptedDistance> distance_;
  glm::dvec3 centre_{0};  // from `cell`
  glm::dmat3 toTool_{1};
  double cells_ = 1;  // of the clay in one of the tool
};

}  // namespace

std::unique_ptr<Solid> makeSculptedSolid(std::shared_ptr<const SculptedDistance> distance,
                                         const Sculpture& sculpture, const DabPose& pose) {
  return std::make_unique<SculptedSolid>(std::move(distance), sculpture, pose);
}

}  // namespace bozzetto::clay
