#include "solid/quad_kernels.hpp"

#include <cmath>

#include "bozzetto/base/simd.hpp"

namespace bozzetto {
namespace {

constexpr std::size_t kLanes = Springs::kLanes;
using Lanes = std::array<double, kLanes>;
using Vectors = std::array<std::array<Lanes, 3>, 4>;  // of four corners: x, y, z side by side
using Batches = std::vector<Springs::Batch>;
using Tangents = std::vector<Springs::BatchTangent>;

BOZZETTO_KERNEL void gather(const Springs::Batch& batch, const glm::dvec3* from, Vectors& out) {
  for (std::size_t c = 0; c < 4; ++c)
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const glm::dvec3& p = from[batch.points[c][lane]];
      out[c][0][lane] = p.x, out[c][1][lane] = p.y, out[c][2][lane] = p.z;
    }
}

BOZZETTO_KERNEL void scatter(const Springs::Batch& batch, const Vectors& values, glm::dvec3* to) {
  for (std::size_t c = 0; c < 4; ++c)
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      glm::dvec3& p = to[batch.points[c][lane]];
      p.x += values[c][0][lane], p.y += values[c][1][lane], p.z += values[c][2][lane];
    }
}

// cosθ of corner c and its gradients by the arms to the next and the previous corner.
struct Cosines {
  Lanes value;
  std::array<Lanes, 3> first, second;
};

BOZZETTO_KERNEL void cosinesAt(const Vectors& p, std::size_t c, Cosines& out) {
  const auto &centre = p[c], &a = p[(c + 1) % 4], &b = p[(c + 3) % 4];
  for (std::size_t n = 0; n < kLanes; ++n) {
    const double ax = a[0][n] - centre[0][n], bx = b[0][n] - centre[0][n];
    const double ay = a[1][n] - centre[1][n], by = b[1][n] - centre[1][n];
    const double az = a[2][n] - centre[2][n], bz = b[2][n] - centre[2][n];
    const double aa = ax * ax + ay * ay + az * az, bb = bx * bx + by * by + bz * bz;
    const double inverse = 1 / std::sqrt(aa * bb);
    const double cosine = (ax * bx + ay * by + az * bz) * inverse;
    const double byA = cosine / aa, byB = cosine / bb;
    out.value[n] = cosine;
    out.first[0][n] = bx * inverse - ax * byA, out.second[0][n] = ax * inverse - bx * byB;
    out.first[1][n] = by * inverse - ay * byA, out.second[1][n] = ay * inverse - by * byB;
    out.first[2][n] = bz * inverse - az * byA, out.second[2][n] = az * inverse - bz * byB;
  }
}

BOZZETTO_KERNEL void forcesOf(const Batches& batches, const glm::dvec3* d, glm::dvec3* force) {
  Vectors p, sum;
  Cosines cosines;
  for (const Springs::Batch& batch : batches) {
    gather(batch, d, p);
    sum = {};
    for (std::size_t c = 0; c < 4; ++c) {
      cosinesAt(p, c, cosines);
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t n = 0; n < kLanes; ++n) {
          const double pull = batch.stiffness[c][n] * (batch.cosine[c][n] - cosines.value[n]);
          const double first = pull * cosines.first[axis][n];
          const double second = pull * cosines.second[axis][n];
          sum[(c + 1) % 4][axis][n] += first;
          sum[(c + 3) % 4][axis][n] += second;
          sum[c][axis][n] -= first + second;
        }
    }
    scatter(batch, sum, force);
  }
}

BOZZETTO_KERNEL void tangentsOf(const Batches& batches, const glm::dvec3* d, Tangents& tangents) {
  Vectors p;
  Cosines cosines;
  for (std::size_t b = 0; b < batches.size(); ++b) {
    gather(batches[b], d, p);
    for (std::size_t c = 0; c < 4; ++c) {
      cosinesAt(p, c, cosines);
      auto& gradient = tangents[b].gradient[c];
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t n = 0; n < kLanes; ++n) {
          const double root = std::sqrt(batches[b].stiffness[c][n]);
          gradient[axis][n] = root * cosines.first[axis][n];
          gradient[3 + axis][n] = root * cosines.second[axis][n];
        }
    }
  }
}

BOZZETTO_KERNEL void timesTangent(const Batches& batches, const Tangents& tangents,
                                  const glm::dvec3* x, glm::dvec3* y) {
  Vectors p, sum;
  for (std::size_t b = 0; b < batches.size(); ++b) {
    gather(batches[b], x, p);
    sum = {};
    for (std::size_t c = 0; c < 4; ++c) {
      const auto& g = tangents[b].gradient[c];
      const auto &centre = p[c], &first = p[(c + 1) % 4], &second = p[(c + 3) % 4];
      Lanes along{};
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t n = 0; n < kLanes; ++n)
          along[n] += g[axis][n] * (first[axis][n] - centre[axis][n]) +
                      g[3 + axis][n] * (second[axis][n] - centre[axis][n]);
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t n = 0; n < kLanes; ++n) {
          const double one = along[n] * g[axis][n], other = along[n] * g[3 + axis][n];
          sum[(c + 1) % 4][axis][n] += one;
          sum[(c + 3) % 4][axis][n] += other;
          sum[c][axis][n] -= one + other;
        }
    }
    scatter(batches[b], sum, y);
  }
}

}  // namespace

BOZZETTO_SIMD_DISPATCH(void, quadForces, forcesOf,
                       (const Batches& batches, const glm::dvec3* d, glm::dvec3* force),
                       (batches, d, force))
BOZZETTO_SIMD_DISPATCH(void, quadTangents, tangentsOf,
                       (const Batches& batches, const glm::dvec3* d, Tangents& tangents),
                       (batches, d, tangents))
BOZZETTO_SIMD_DISPATCH(void, quadTangentTimes, timesTangent,
                       (const Batches& batches, const Tangents& tangents, const glm::dvec3* x,
                        glm::dvec3* y),
                       (batches, tangents, x, y))

}  // namespace bozzetto
