// The point of a triangle nearest to a place (Ericson, Real-Time Collision Detection, §5.1.5).
#pragma once
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace bozzetto {

/// Nearest point = a + u·(b - a) + v·(c - a).
struct NearestPoint {
  double squared = 0;  ///< squared distance
  double u = 0, v = 0;
  bool onFace() const { return u > 1e-6 && v > 1e-6 && u + v < 1 - 1e-6; }
};

class DistanceTriangle {
 public:
  DistanceTriangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
      : a_(a), ab_(b - a), ac_(c - a), normal_(glm::cross(ab_, ac_)) {
    abab_ = glm::dot(ab_, ab_);
    abac_ = glm::dot(ab_, ac_);
    acac_ = glm::dot(ac_, ac_);
  }

  const glm::dvec3& normal() const { return normal_; }  ///< not of unit length
  glm::dvec3 at(double u, double v) const { return a_ + u * ab_ + v * ac_; }
  bool isFrontOf(const glm::dvec3& p) const { return glm::dot(p - a_, normal_) > 0; }

  NearestPoint nearestTo(const glm::dvec3& p) const {
    const glm::dvec3 ap = p - a_;
    const double d1 = glm::dot(ab_, ap), d2 = glm::dot(ac_, ap);
    if (d1 <= 0 && d2 <= 0) return found(ap, 0, 0);
    const double d3 = d1 - abab_, d4 = d2 - abac_;
    if (d3 >= 0 && d4 <= d3) return found(ap, 1, 0);
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return found(ap, d1 / (d1 - d3), 0);
    const double d5 = d1 - abac_, d6 = d2 - acac_;
    if (d6 >= 0 && d5 <= d6) return found(ap, 0, 1);
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return found(ap, 0, d2 / (d2 - d6));
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 >= d3 && d5 >= d6) {
      const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
      return found(ap, 1 - w, w);
    }
    const double scale = 1 / (va + vb + vc);
    return found(ap, vb * scale, vc * scale);
  }

 private:
  NearestPoint found(const glm::dvec3& ap, double u, double v) const {
    // A needle may divide nothing by nothing: take its first corner.
    if (!(u >= 0 && v >= 0)) u = v = 0;
    const auto r = ap - u * ab_ - v * ac_;
    return {glm::dot(r, r), u, v};
  }

  glm::dvec3 a_, ab_, ac_, normal_;
  double abab_, abac_, acac_;
};

}  // namespace bozzetto
