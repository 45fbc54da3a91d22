#include "bozzetto/render/pick.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "bozzetto/field/sampler.hpp"

namespace bozzetto {
namespace {

using glm::dvec2;
using glm::dvec3;

// The plane across the view at depth 1 (or at any depth, for parallel rays), in cells.
struct Window {
  dvec2 half;
  bool perspective;

  explicit Window(const Shot& shot) {
    const Camera& camera = shot.camera;
    perspective = camera.projection == Projection::perspective;
    const double up = std::tan(camera.fieldOfView / 2) * (perspective ? 1 : camera.distance);
    half = {up * shot.width / shot.height, up};
  }
};

double eyeShearAt(const Shot& shot, double depth) {
  if (shot.eye.plane <= 0) return 0;
  return shot.eye.sideways * (1 - depth / shot.eye.plane);
}

// Steps from cell to cell, or over blocks without surface, along a ray through the lattice.
class Walk {
 public:
  Walk(const Clay& clay, const Ray& ray, double reach)
      : ray_(ray), reach_(reach), blocks_(clay.tree), sampler_(clay), iso_(clay.scale.iso) {
    const dvec3 o = ray.origin;
    origin_ = {std::int32_t(std::floor(o.x)), std::int32_t(std::floor(o.y)),
               std::int32_t(std::floor(o.z))};
    local_ = o - dvec3(origin_.i, origin_.j, origin_.k);
  }

  std::optional<double> firstInside();

 private:
  using Block = Clay::Block;
  using Geometry = Clay::Geometry;

  CellPoint at(double distance) const {
    return cellPoint(origin_, local_ + ray_.direction * distance);
  }
  float above(double distance) { return sampler_.value(at(distance)) - iso_; }

  // Distance at which the ray leaves the cube of `side` cells at `corner`.
  double leaves(Key corner, int side) const {
    double out = reach_;
    const Key from = corner - origin_;
    for (const Axis axis : kAxes) {
      const double d = ray_.direction[index(axis)];
      if (d == 0) continue;
      const double plane = from[axis] + (d > 0 ? side : 0);
      out = std::min(out, (plane - local_[index(axis)]) / d);
    }
    return out;
  }

  // Density near the block is below iso all over: its own corners and those one beyond.
  bool isEmpty(Key block) {
    for (int n = 0; n < 8; ++n) {
      const Block* b = blocks_.find(block + Key{n >> 2 & 1, n >> 1 & 1, n & 1});
      if (b != nullptr && b->high >= iso_) return false;
    }
    return true;
  }

  std::optional<double> inCell(double begin, double end);

  const Ray& ray_;
  double reach_;
  BlockCache<Block> blocks_;
  FieldSampler<8> sampler_;
  float iso_;
  Key origin_;
  dvec3 local_{0};
};

// Along a ray the density of a cell is a cubic: a rise above iso between two places below it shows
// at its quarter points but for grazes thinner than a hundredth of a cell.
std::optional<double> Walk::inCell(double begin, double end) {
  double low = begin;
  for (int n = 0; n <= 4; ++n) {
    const double t = begin + (end - begin) * n / 4;
    if (above(t) < 0) {
      low = t;
      continue;
    }
    double high = t;
    for (int step = 0; step < 24 && high - low > 1e-5; ++step) {
      const double middle = (low + high) / 2;
      (above(middle) < 0 ? low : high) = middle;
    }
    return high;
  }
  return std::nullopt;
}

std::optional<double> Walk::firstInside() {
  constexpr double kNudge = 1e-7;  // past a side, so that the next cube is found
  for (double t = 0; t < reach_;) {
    const Key corner = at(t + kNudge).base;
    const Key block = Geometry::blockOf(corner);
    if (isEmpty(block)) {
      t = std::max(leaves(Geometry::firstCornerOf(block), 8), t + kNudge);
      continue;
    }
    const double end = std::max(leaves(corner, 1), t + kNudge);
    if (const auto hit = inCell(t, std::min(end, reach_))) return hit;
    t = end;
  }
  return std::nullopt;
}

}  // namespace

Ray rayThrough(const Shot& shot, dvec2 pixel) {
  const Window window(shot);
  const dvec2 place = dvec2(2 * pixel.x / shot.width - 1, 1 - 2 * pixel.y / shot.height);
  const auto through = [&](double depth) {
    const dvec2 p = place * window.half * (window.perspective ? depth : 1);
    return dvec3(p.x + eyeShearAt(shot, depth), p.y, -depth);
  };
  const glm::dmat3 axes = shot.camera.worldFromView();
  const dvec3 start = through(0);
  return {shot.camera.eye() + axes * start, glm::normalize(axes * (through(1) - start))};
}

std::optional<Seen> seenAt(const Shot& shot, const dvec3& place) {
  const dvec3 p = glm::transpose(shot.camera.worldFromView()) * (place - shot.camera.eye());
  const double depth = -p.z;
  const Window window(shot);
  if (window.perspective && depth <= 0) return std::nullopt;
  const double scale = window.perspective ? depth : 1;
  const dvec2 ndc = dvec2(p.x - eyeShearAt(shot, depth), p.y) / (window.half * scale);
  return Seen{{(ndc.x + 1) / 2 * shot.width, (1 - ndc.y) / 2 * shot.height}, depth};
}

double cellsPerPixel(const Shot& shot, const dvec3& place) {
  const Window window(shot);
  const dvec3 back = shot.camera.worldFromView()[2];
  const double depth = glm::dot(back, shot.camera.eye() - place);
  return 2 * window.half.y / shot.height * (window.perspective ? std::max(depth, 0.0) : 1);
}

std::optional<Hit> pick(const Clay& clay, const Ray& ray, double reach) {
  const auto distance = Walk(clay, ray, reach).firstInside();
  if (!distance) return std::nullopt;
  Hit hit{ray.at(*distance), -ray.direction, *distance};
  FieldSampler<8> sampler(clay);
  const glm::vec3 inwards = sampler.gradient(cellPoint({}, hit.place));
  if (glm::dot(inwards, inwards) > 1e-12f) hit.normal = -glm::normalize(inwards);
  return hit;
}

std::optional<dvec3> meetPlane(const Ray& ray, const dvec3& point, const dvec3& normal) {
  const double facing = glm::dot(ray.direction, normal);
  if (std::abs(facing) < 1e-9) return std::nullopt;
  const double distance = glm::dot(point - ray.origin, normal) / facing;
  if (distance < 0) return std::nullopt;
  return ray.at(distance);
}

}  // namespace bozzetto
