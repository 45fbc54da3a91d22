// Gauges: u(p) of a convex shape, 0 at the centre, 1 on its limit, proportional along rays. They
// take |local position| and return u², and never fall when a component grows: so the gauge of the
// nearest corner of a box bounds the box.
#pragma once
#include <algorithm>
#include <glm/vec3.hpp>

#include "tool/float_bits.hpp"

namespace bozzetto {

struct EllipsoidGauge {
  explicit EllipsoidGauge(const glm::dvec3&) {}
  BOZZETTO_KERNEL float operator()(float x, float y, float z) const {
    return (x * x + y * y) + z * z;
  }
};

struct CylinderGauge {
  explicit CylinderGauge(const glm::dvec3&) {}
  BOZZETTO_KERNEL float operator()(float x, float y, float z) const {
    const float round = x * x + z * z, flat = y * y;
    return greater(round, flat);
  }
};

// The smaller root of a·u² − 2·b·u + c = 0, for b and c ≥ 0 and a of any sign:
// c / (b + √(b² − a·c)), 0 where all are 0.
BOZZETTO_KERNEL float smallerRoot(float a, float b, float c) {
  return c / (b + std::sqrt(positive(b * b - a * c)) + 1e-30f);
}

// A segment of half length l along y plus an ellipsoid with half axes (1, c, 1), l + c = 1.
class CapsuleGauge {
 public:
  explicit CapsuleGauge(const glm::dvec3& radii) {
    const double cap = std::min(radii.y, std::sqrt(radii.x * radii.z)) / radii.y;
    length_ = static_cast<float>(1 - cap);
    cap_ = static_cast<float>(cap);
  }
  BOZZETTO_KERNEL float operator()(float x, float y, float z) const {
    const float round = x * x + z * z;
    // Beside the segment u² = round; beyond it (y − u·l)² = c²·(u² − round).
    const float u =
        smallerRoot(length_ * length_ - cap_ * cap_, y * length_, y * y + (cap_ * cap_) * round);
    return pick(lessMask(round * (length_ * length_), y * y), u * u, round);
  }

 private:
  float length_, cap_;
};

// A box of half sides b plus a ball of radius r, b + r = radii: ∑ max(q − u·b, 0)² = (u·r)².
class BoxGauge {
 public:
  static constexpr double kRounding = 0.25;  // of the smallest radius

  explicit BoxGauge(const glm::dvec3& radii) {
    const double smallest = std::min({radii.x, radii.y, radii.z});
    for (int axis = 0; axis < 3; ++axis) {
      scale_[axis] = static_cast<float>(radii[axis] / smallest);
      core_[axis] = static_cast<float>(radii[axis] / smallest - kRounding);
    }
  }
  BOZZETTO_KERNEL float operator()(float x, float y, float z) const {
    Side a{x * scale_[0], core_[0]}, b{y * scale_[1], core_[1]}, c{z * scale_[2], core_[2]};
    // Sides join the sum in the order in which growing u passes them: falling q/core.
    order(a, b);
    order(b, c);
    order(a, b);
    constexpr float rounding = kRounding, r2 = rounding * rounding;
    const float one = a.q / (a.core + rounding);
    const float c2 = a.core * a.core + b.core * b.core - r2, b2 = a.q * a.core + b.q * b.core,
                a2 = a.q * a.q + b.q * b.q;
    const float two = smallerRoot(c2, b2, a2);
    const float three = smallerRoot(c2 + c.core * c.core, b2 + c.q * c.core, a2 + c.q * c.q);
    const float most = pick(lessMask(two * c.core, c.q), three, two);
    const float u = pick(lessMask(one * b.core, b.q), most, one);
    return u * u;
  }

 private:
  struct Side {
    float q, core;
  };
  BOZZETTO_KERNEL static void order(Side& first, Side& second) {
    const auto swap = lessMask(first.q * second.core, second.q * first.core);
    const Side before = first;
    first = {pick(swap, second.q, first.q), pick(swap, second.core, first.core)};
    second = {pick(swap, before.q, second.q), pick(swap, before.core, second.core)};
  }

  float scale_[3], core_[3];
};

// f(u) = 1 − 4/9·u⁶ + 17/9·u⁴ − 22/9·u² (Ferley §4.1.1, after Wyvill), as (1 − u²)²·(1 − 4/9·u²),
// which has no cancellation at the limit.
struct WyvillProfile {
  BOZZETTO_KERNEL float operator()(float u2) const {
    const float rest = 1.0f - u2;
    const float f = (rest * rest) * (1.0f - (4.0f / 9.0f) * u2);
    return pick(lessMask(u2, 1.0f), f, 0.0f);
  }
};

struct BoxProfile {
  static constexpr float kCore = 0.7f;
  BOZZETTO_KERNEL float operator()(float u2) const {
    const float u = std::sqrt(u2);
    const float t = (u - kCore) / (1.0f - kCore);
    const float f = 1.0f - (t * t) * (3.0f - 2.0f * t);
    const float fall = pick(lessMask(kCore, u), f, 1.0f);
    return pick(lessMask(u2, 1.0f), fall, 0.0f);
  }
};

}  // namespace bozzetto
