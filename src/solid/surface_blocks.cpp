#include "solid/surface_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "bozzetto/base/parallel.hpp"

namespace bozzetto {
namespace {

constexpr int kSide = 8;
constexpr std::size_t kChunk = 512;

// Halves boxes of blocks until they are single ones, and drops those that the triangle's plane or
// one of its sides, seen along its normal, keeps away from.
class Finder {
 public:
  Finder(const TriangleMesh& mesh, std::uint32_t triangle, double reach)
      : triangle_(triangle), reach_(reach) {
    for (std::size_t n = 0; n < 3; ++n) corner_[n] = mesh.positions[mesh.triangles[triangle][n]];
    const glm::dvec3 normal = glm::cross(corner_[1] - corner_[0], corner_[2] - corner_[0]);
    const double length = glm::length(normal);
    if (length <= 0) return;
    planes_[0] = {normal / length, glm::dot(normal / length, corner_[0])};
    for (std::size_t n = 0; n < 3; ++n) {
      const glm::dvec3 side = corner_[(n + 1) % 3] - corner_[n];
      const glm::dvec3 outward = glm::normalize(glm::cross(side, normal));
      planes_[n + 1] = {outward, glm::dot(outward, corner_[n])};
    }
  }

  void run(std::vector<NearTriangle>& found) {
    const glm::dvec3 low = glm::min(glm::min(corner_[0], corner_[1]), corner_[2]) - reach_;
    const glm::dvec3 high = glm::max(glm::max(corner_[0], corner_[1]), corner_[2]) + reach_;
    Key first, last;
    for (const Axis axis : kAxes) {
      const int a = index(axis);
      const double block = std::ceil((low[a] - (kSide - 1)) / kSide - 1e-9);
      first[axis] = static_cast<std::int32_t>(std::max(0.0, block));
      last[axis] = static_cast<std::int32_t>(std::floor(high[a] / kSide));
      if (first[axis] > last[axis]) return;
    }
    descend(first, last, found);
  }

 private:
  struct Plane {
    glm::dvec3 normal{0};
    double offset = 0;
  };

  void descend(Key first, Key last, std::vector<NearTriangle>& found) {
    if (!mayMeet(first, last)) return;
    Axis axis = Axis::x;
    for (const Axis each : kAxes)
      if (last[each] - first[each] > last[axis] - first[axis]) axis = each;
    if (first[axis] == last[axis]) return found.push_back({NearTriangle::codeOf(first), triangle_});
    const std::int32_t middle = first[axis] + (last[axis] - first[axis]) / 2;
    Key lowEnd = last, highStart = first;
    lowEnd[axis] = middle;
    highStart[axis] = middle + 1;
    descend(first, lowEnd, found);
    descend(highStart, last, found);
  }

  bool mayMeet(Key first, Key last) const {
    glm::dvec3 middle, half;
    for (const Axis axis : kAxes) {
      const double low = double(first[axis]) * kSide, high = double(last[axis]) * kSide + kSide - 1;
      middle[index(axis)] = (low + high) / 2;
      half[index(axis)] = (high - low) / 2;
    }
    for (std::size_t n = 0; n < planes_.size(); ++n) {
      const Plane& plane = planes_[n];
      const double distance = glm::dot(plane.normal, middle) - plane.offset;
      const double room = glm::dot(glm::abs(plane.normal), half) + reach_;
      if (distance > room || (n == 0 && distance < -room)) return false;
    }
    return true;
  }

  std::uint32_t triangle_;
  double reach_;
  std::array<glm::dvec3, 3> corner_;
  std::array<Plane, 4> planes_;
};

}  // namespace

std::vector<NearTriangle> nearTriangles(const TriangleMesh& mesh, double reach) {
  const std::size_t count = mesh.triangles.size();
  std::vector<std::vector<NearTriangle>> chunks((count + kChunk - 1) / kChunk);
  parallelFor(chunks.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t chunk = begin; chunk < end; ++chunk) {
      const std::size_t last = std::min((chunk + 1) * kChunk, count);
      for (std::size_t n = chunk * kChunk; n < last; ++n)
        Finder(mesh, static_cast<std::uint32_t>(n), reach).run(chunks[chunk]);
    }
  });
  std::vector<NearTriangle> all;
  for (const auto& chunk : chunks) all.insert(all.end(), chunk.begin(), chunk.end());
  std::ranges::sort(all, [](const NearTriangle& a, const NearTriangle& b) {
    return a.code != b.code ? a.code < b.code : a.triangle < b.triangle;
  });
  return all;
}

}  // namespace bozzetto
