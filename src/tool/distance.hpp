// Signed distances to primitives, in cells, from |local position|; negative inside. For Real float
// they vectorise. The caller orders axes so that x is the shortest of those that are round.
#pragma once
#include <algorithm>
#include <glm/vec3.hpp>

#include "tool/float_bits.hpp"

namespace bozzetto {

struct BallDistance {
  explicit BallDistance(const glm::dvec3& radii) : radius(radii.x) {}
  template <class Real>
  BOZZETTO_KERNEL Real operator()(Real x, Real y, Real z) const {
    return std::sqrt((x * x + y * y) + z * z) - static_cast<Real>(radius);
  }
  double radius;
};

// The nearest point of the ellipsoid to x is y_a = r_a²·x_a / (t + r_a²), with t the root of
// S(t) = ∑ (r_a·x_a / (t + r_a²))² = 1 (Eberly, "Distance from a point to an ellipse, an ellipsoid,
// or a hyperellipsoid"). Newton on 1/√S, which is straight for a ball and nearly so for the rest.
struct EllipsoidDistance {
  static constexpr int kSteps = 6;
  explicit EllipsoidDistance(const glm::dvec3& lengths) : radii(lengths) {}

  template <class Real>
  BOZZETTO_KERNEL Real operator()(Real x, Real y, Real z) const {
    const auto rx = static_cast<Real>(radii.x), ry = static_cast<Real>(radii.y),
               rz = static_cast<Real>(radii.z);
    const Real xx = rx * rx, yy = ry * ry, zz = rz * rz;
    const Real px = rx * x, py = ry * y, pz = rz * z;
    const Real lowest = xx * Real(-0.9999);
    Real t = 0, ix = 1 / xx, iy = 1 / yy, iz = 1 / zz;
    Real sx = px * ix, sy = py * iy, sz = pz * iz;
    Real sum = (sx * sx + sy * sy) + sz * sz;
    const Real sum0 = sum;
    for (int n = 0; n < kSteps; ++n) {
      const Real slope = (sx * sx * ix + sy * sy * iy) + sz * sz * iz;
      const Real moved = t + sum * (std::sqrt(sum) - 1) / (slope + Real(1e-30));
      t = lowest + positive(moved - lowest);
      ix = 1 / (t + xx);
      iy = 1 / (t + yy);
      iz = 1 / (t + zz);
      sx = px * ix;
      sy = py * iy;
      sz = pz * iz;
      sum = (sx * sx + sy * sy) + sz * sz;
    }
    // Inside, near the plane of the two long axes, the nearest point lies off that plane.
    const Real left = positive(1 - (sy * sy + sz * sz));
    const auto deep = lessMask(sum, Real(0.999));
    const Real nx = rx * pick(deep, std::sqrt(left), sx), ny = ry * sy, nz = rz * sz;
    const Real dx = x - nx, dy = y - ny, dz = z - nz;
    const Real distance = std::sqrt((dx * dx + dy * dy) + dz * dz);
    return pick(lessMask(Real(1), sum0), distance, -distance);
  }
  glm::dvec3 radii;
};

struct BoxDistance {
  explicit BoxDistance(const glm::dvec3& halves) : radii(halves) {}
  template <class Real>
  BOZZETTO_KERNEL Real operator()(Real x, Real y, Real z) const {
    const Real qx = x - static_cast<Real>(radii.x), qy = y - static_cast<Real>(radii.y),
               qz = z - static_cast<Real>(radii.z);
    const Real ox = positive(qx), oy = positive(qy), oz = positive(qz);
    const Real depth = lesser(lesser(positive(-qx), positive(-qy)), positive(-qz));
    return std::sqrt((ox * ox + oy * oy) + oz * oz) - depth;
  }
  glm::dvec3 radii;
};

// About y; `Round` is the distance to its outline in the plane y = 0.
template <class Round>
struct CylinderDistance {
  explicit CylinderDistance(const glm::dvec3& radii)
      : round({radii.x, std::max(radii.x, radii.z), radii.z}), half(radii.y) {}
  template <class Real>
  BOZZETTO_KERNEL Real operator()(Real x, Real y, Real z) const {
    const Real across = round(x, Real(0), z), along = y - static_cast<Real>(half);
    const Real oa = positive(across), ob = positive(along);
    return std::sqrt(oa * oa + ob * ob) - lesser(positive(-across), positive(-along));
  }
  Round round;
  double half;
};

// About y: a segment of half length `straight` plus what `Round` measures.
template <class Round>
struct CapsuleDistance {
  explicit CapsuleDistance(const glm::dvec3& radii)
      : CapsuleDistance(radii, std::min(radii.y, std::sqrt(radii.x * radii.z))) {}
  CapsuleDistance(const glm::dvec3& radii, double cap)
      : round({radii.x, cap, radii.z}), straight(radii.y - cap) {}
  template <class Real>
  BOZZETTO_KERNEL Real operator()(Real x, Real y, Real z) const {
    return round(x, positive(y - static_cast<Real>(straight)), z);
  }
  Round round;
  double straight;
};

}  // namespace bozzetto
