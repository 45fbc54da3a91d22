#include "ui/press.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

namespace bozzetto::ui {
namespace {

constexpr int kRays = 8;  // about the pointer's

// Half the width of a tool along a direction of length 1 in its own axes (its support function). A
// sculpture counts as the ellipsoid in its box.
double halfWidth(Shape shape, const glm::dvec3& radii, const glm::dvec3& direction) {
  const glm::dvec3 along = glm::abs(direction), part = radii * along;
  switch (shape) {
    case Shape::box: {
      const double rounded = std::min({radii.x, radii.y, radii.z}) / 4;
      return glm::dot(radii - rounded, along) + rounded;
    }
    case Shape::cylinder:
      return std::hypot(part.x, part.z) + part.y;
    case Shape::capsule: {
      const double cap = std::min(radii.y, std::sqrt(radii.x * radii.z));
      return (radii.y - cap) * along.y + std::hypot(part.x, cap * along.y, part.z);
    }
    default:
      return glm::length(part);
  }
}

}  // namespace

std::optional<GroundHit> groundUnder(const PatchSet& patches, const Ray& ray, double spacing) {
  const auto hit = patches.pick({ray.origin / spacing, ray.direction});
  if (!hit) return std::nullopt;
  return GroundHit{hit->position * spacing, hit->normal};
}

glm::dvec3 broadNormal(const PatchSet& patches, const Ray& ray, const GroundHit& hit, double radius,
                       double spacing) {
  const glm::dvec3 aside =
      std::abs(ray.direction.x) < .5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 right = glm::normalize(glm::cross(ray.direction, aside));
  const glm::dvec3 up = glm::cross(right, ray.direction);
  glm::dvec3 sum = hit.normal;
  for (int n = 0; n < kRays; ++n) {
    const double turn = 2 * glm::pi<double>() * n / kRays;
    const glm::dvec3 beside = radius / 2 * (std::cos(turn) * right + std::sin(turn) * up);
    const auto found = groundUnder(patches, {ray.origin + beside, ray.direction}, spacing);
    if (found && glm::distance(found->position, hit.position) < radius) sum += found->normal;
  }
  const double length = glm::length(sum);
  return length > 1e-3 ? sum / length : hit.normal;
}

Press::Press(const ToolShape& tool, const SculptState& state, double spacing)
    : tool_(tool),
      share_(state.strengthOf(ActionKind::push)),
      pressure_{state.pressureStrength, state.pressureSize} {
  const double least = kSmallestToolCells * spacing;
  if (tool_.sculpture) {
    pivot_ = tool_.sculpture->pivot() * tool_.radii / tool_.sculpture->halfExtents();
  } else {
    tool_.radii = glm::max(tool_.radii, least);  // as fitTool
  }
  least_ = std::min(1.0, least / std::min({tool_.radii.x, tool_.radii.y, tool_.radii.z}));
}

glm::dvec3 Press::lift(const glm::dvec3& normal, double pressure) const {
  const double size = pressure_.size ? std::max(pressure, least_) : 1;
  const double sinks = share_ * (pressure_.strength ? pressure : 1);
  const glm::dvec3 up = glm::conjugate(normalisedRotation(tool_.rotation)) * normal;
  const double width = halfWidth(tool_.shape, tool_.radii, up);
  return normal * (size * (width * (1 - sinks) + glm::dot(pivot_, up)));
}

double Press::radius() const { return std::max({tool_.radii.x, tool_.radii.y, tool_.radii.z}); }

}  // namespace bozzetto::ui
