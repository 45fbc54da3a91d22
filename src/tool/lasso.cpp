#include "bozzetto/tool/lasso.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "bozzetto/base/error.hpp"

namespace bozzetto {
namespace {

constexpr std::size_t kMostPoints = 10'000;

glm::dvec3 inView(const Lasso& lasso, const glm::dvec3& place) {
  return glm::conjugate(lasso.worldFromView) * (place - lasso.eye);
}

// Crossings of a ray to the right, counted even or odd.
bool encloses(const std::vector<glm::dvec2>& outline, const glm::dvec2& at) {
  bool inside = false;
  for (std::size_t n = 0, before = outline.size() - 1; n < outline.size(); before = n++) {
    const glm::dvec2 &a = outline[before], &b = outline[n];
    if ((a.y > at.y) == (b.y > at.y)) continue;
    if (at.x < a.x + (b.x - a.x) * (at.y - a.y) / (b.y - a.y)) inside = !inside;
  }
  return inside;
}

double distanceTo(const glm::dvec2& at, const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 side = b - a, away = at - a;
  const double square = glm::dot(side, side);
  const double t = square > 0 ? std::clamp(glm::dot(away, side) / square, 0.0, 1.0) : 0;
  return glm::length(away - t * side);
}

double distanceTo(const std::vector<glm::dvec2>& outline, const glm::dvec2& at) {
  double least = HUGE_VAL;
  for (std::size_t n = 0, before = outline.size() - 1; n < outline.size(); before = n++)
    least = std::min(least, distanceTo(at, outline[before], outline[n]));
  return least;
}

}  // namespace

bool Lasso::sees(const glm::dvec3& place, glm::dvec2& at) const {
  const glm::dvec3 view = inView(*this, place);
  at = {view.x, view.y};
  if (rays == LassoRays::parallel) return true;
  at /= -view.z;
  return view.z < 0;
}

bool Lasso::holds(const glm::dvec3& place) const {
  glm::dvec2 at(0);
  return sees(place, at) && encloses(outline, at);
}

void requireValid(const Lasso& lasso) {
  const std::size_t count = lasso.outline.size();
  if (count < 3 || count > kMostPoints)
    throw Error("lasso: found " + std::to_string(count) + " points, expected 3 to " +
                std::to_string(kMostPoints));
  glm::dvec3 sum = lasso.eye;
  for (const glm::dvec2& point : lasso.outline) sum += glm::dvec3(point, 0);
  if (!std::isfinite(sum.x + sum.y + sum.z)) throw Error("lasso: found a place that is not finite");
}

Coverage coverageOf(const Lasso& lasso, const glm::dvec3& centre, double radius) {
  glm::dvec2 at(0);
  double reach = radius;
  const bool seen = lasso.sees(centre, at);
  if (lasso.rays == LassoRays::fromEye) {
    const double depth = -inView(lasso, centre).z;
    if (depth < -radius) return Coverage::none;
    if (!seen || depth < 2 * radius) return Coverage::some;
    reach = radius * (1 + glm::length(at)) / (depth - radius);
  }
  if (distanceTo(lasso.outline, at) <= reach) return Coverage::some;
  return encloses(lasso.outline, at) ? Coverage::all : Coverage::none;
}

}  // namespace bozzetto
