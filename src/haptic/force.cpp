#include "bozzetto/haptic/force.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace bozzetto::haptic {

double passiveStiffness(double deviceDamping, double virtualDamping, double seconds) {
  return std::max(0.0, 2 * (deviceDamping - std::abs(virtualDamping)) / seconds);
}

glm::dvec3 limited(const glm::dvec3& force, double most) {
  const double length = glm::length(force);
  return length > most ? force * (most / length) : force;
}

glm::dvec3 ropeForce(const glm::dvec3& device, const glm::dvec3& grabbed, double stiffness,
                     const ForceLimits& limits) {
  const double k = std::min(stiffness, limits.stiffness);
  return limited(-k * (device - grabbed), limits.force);
}

void GrabbedPoint::arrive(const glm::dvec3& place, double time) {
  from_ = count_ == 0 ? place : at(time);
  to_ = place;
  length_ = count_ == 0 ? 0 : time - since_;
  since_ = time;
  count_ = std::min(count_ + 1, 2);
}

glm::dvec3 GrabbedPoint::at(double time) const {
  if (length_ <= 0) return to_;
  const double t = std::clamp((time - since_) / length_, 0.0, 1.0);
  return (1 - t) * from_ + t * to_;
}

// Ericson, Real-Time Collision Detection, §5.1.5.
glm::dvec3 nearestOn(const TouchTriangle& t, const glm::dvec3& p) {
  const glm::dvec3 ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0], bp = p - t[1], cp = p - t[2];
  const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return t[0];
  const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return t[1];
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return t[0] + d1 / (d1 - d3) * ab;
  const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return t[2];
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return t[0] + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    return t[1] + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (t[2] - t[1]);
  const double sum = va + vb + vc;
  return t[0] + vb / sum * ab + vc / sum * ac;
}

SurfaceProxy::Touch SurfaceProxy::touch(std::span<const TouchTriangle> surface,
                                        const glm::dvec3& device, double stiffness,
                                        const ForceLimits& limits) {
  Touch result;
  double least = 1e300;
  glm::dvec3 normal(0);
  for (const TouchTriangle& triangle : surface) {
    const glm::dvec3 place = nearestOn(triangle, device);
    const glm::dvec3 away = device - place,
                     facing = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    const double squared = glm::dot(away, away);
    // Over an edge both triangles are equally near: the one that is seen most face on decides.
    const bool tie = std::abs(squared - least) <= 1e-12 * least;
    const bool better = !tie ? squared < least
                             : std::abs(glm::dot(glm::normalize(facing), away)) >
                                   std::abs(glm::dot(glm::normalize(normal), away));
    if (!better) continue;
    least = squared;
    result.proxy = place;
    normal = facing;
  }
  inside_ = !surface.empty() && glm::dot(device - result.proxy, normal) < 0;
  result.touching = inside_;
  if (inside_) result.force = ropeForce(device, result.proxy, stiffness, limits);
  return result;
}

}  // namespace bozzetto::haptic
