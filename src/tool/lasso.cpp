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

glm::dvec2 nearestOn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& at) {
  const glm::dvec2 side = b - a, away = at - a;
  const double square = glm::dot(side, side);
  const double t = square > 0 ? std::clamp(glm::dot(away, side) / square, 0.0, 1.0) : 0;
  return a + t * side;
}

glm::dvec2 nearestOn(const std::vector<glm::dvec2>& outline, const glm::dvec2& at) {
  glm::dvec2 nearest(0);
  double least = HUGE_VAL;
  for (std::size_t n = 0, before = outline.size() - 1; n < outline.size(); before = n++) {
    const glm::dvec2 each = nearestOn(outline[before], outline[n], at);
    const double distance = glm::length(each - at);
    if (distance >= least) continue;
    least = distance;
    nearest = each;
  }
  return nearest;
}

}  // namespace

bool Lasso::sees(const glm::dvec3& place, glm::dvec2& at) const {
  const glm::dvec3 view = inView(*this, place);
  at = {view.x, view.y};
  if (rays == LassoRays::parallel) return true;
  at /= -view.z;
  return view.z < 0;
}

// By the distance to the ray through the nearest place of the outline.
double Lasso::share(const glm::dvec3& place, double cell) const {
  glm::dvec2 at(0);
  if (!sees(place, at)) return 0;
  const glm::dvec2 nearest = nearestOn(outline, at);
  double distance = glm::length(at - nearest);
  if (rays == LassoRays::fromEye) {
    const glm::dvec3 view = inView(*this, place), ray = glm::normalize(glm::dvec3(nearest, -1));
    distance = glm::length(view - glm::dot(view, ray) * ray);
  }
  const double inside = encloses(outline, at) ? distance : -distance;
  return std::clamp(0.5 + inside / (2 * cell), 0.0, 1.0);
}

namespace {

// No point is further from the line through the two that lie furthest along it than rounding.
bool onOneLine(const std::vector<glm::dvec2>& outline) {
  const auto from = [](const glm::dvec2& a) {
    return [a](const glm::dvec2& p, const glm::dvec2& q) {
      return glm::length(p - a) < glm::length(q - a);
    };
  };
  const glm::dvec2 first = outline.front();
  const glm::dvec2 far = *std::ranges::max_element(outline, from(first)) - first;
  const double square = glm::dot(far, far);
  return std::ranges::all_of(outline, [&](const glm::dvec2& point) {
    const glm::dvec2 away = point - first;
    return std::abs(far.x * away.y - far.y * away.x) <= 1e-9 * square;
  });
}

}  // namespace

void requireValid(const Lasso& lasso) {
  const std::size_t count = lasso.outline.size();
  if (count < 3 || count > kMostPoints)
    throw Error("lasso: found " + std::to_string(count) + " points, expected 3 to " +
                std::to_string(kMostPoints));
  glm::dvec3 sum = lasso.eye;
  for (const glm::dvec2& point : lasso.outline) sum += glm::dvec3(point, 0);
  if (!std::isfinite(sum.x + sum.y + sum.z)) throw Error("lasso: found a place that is not finite");
  if (onOneLine(lasso.outline))
    throw Error("lasso: " + std::to_string(count) +
                " points on one line found, an outline round something expected");
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
  if (glm::length(nearestOn(lasso.outline, at) - at) <= reach) return Coverage::some;
  return encloses(lasso.outline, at) ? Coverage::all : Coverage::none;
}

}  // namespace bozzetto
