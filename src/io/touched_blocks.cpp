#include "io/touched_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "bozzetto/base/error.hpp"
#include "bozzetto/base/parallel.hpp"
#include "io/triangle_distance.hpp"

namespace bozzetto {
namespace {

constexpr int kSide = 8;
constexpr std::size_t kChunk = 4096;
// Of one chunk; only needles millions of cells long come near.
constexpr std::size_t kMostPairs = std::size_t{1} << 26;

// One triangle against boxes of blocks, halved until they are single blocks.
class Toucher {
 public:
  Toucher(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, double reach)
      : reach_(reach),
        low_(glm::min(glm::min(a, b), c)),
        high_(glm::max(glm::max(a, b), c)),
        corner_(a),
        triangleAt_(a, b, c) {}

  void run(std::uint32_t triangle, std::vector<BlockTriangle>& out) {
    triangle_ = triangle;
    out_ = &out;
    Key low, high;
    for (const Axis axis : kAxes) {
      const int a = index(axis);
      low[axis] = std::max(0, blockAt(low_[a] - reach_ - (kSide - 1), true));
      high[axis] = blockAt(high_[a] + reach_, false);
      if (low[axis] > high[axis]) return;
    }
    descend(low, high);
  }

 private:
  // The first block that starts at or after a place, or the last that starts at or before it.
  static std::int32_t blockAt(double place, bool after) {
    const double block = place / kSide;
    return static_cast<std::int32_t>(after ? std::ceil(block) : std::floor(block));
  }

  void descend(Key low, Key high) {
    if (!meets(low, high)) return;
    const Axis axis = longest(low, high);
    if (low[axis] == high[axis]) {
      if (out_->size() >= kMostPairs)
        throw Error("import: found needles of millions of cells, expected less");
      out_->push_back({packBlock(low), triangle_});
      return;
    }
    const std::int32_t middle = low[axis] + (high[axis] - low[axis]) / 2;
    Key lowEnd = high, highStart = low;
    lowEnd[axis] = middle;
    highStart[axis] = middle + 1;
    descend(low, lowEnd);
    descend(highStart, high);
  }

  static Axis longest(Key low, Key high) {
    const Key size = high - low;
    Axis best = Axis::x;
    for (const Axis axis : kAxes) {
      if (size[axis] > size[best]) best = axis;
    }
    return best;
  }

  // The triangle's plane against the box of corners, grown by the reach, and the ball round it:
  // the one is sharp for large triangles, the other for needles.
  bool meets(Key low, Key high) const {
    glm::dvec3 middle, half;
    for (const Axis axis : kAxes) {
      const double first = double(low[axis]) * kSide, last = double(high[axis]) * kSide + kSide - 1;
      middle[index(axis)] = (first + last) / 2;
      half[index(axis)] = (last - first) / 2 + reach_;
    }
    const auto& normal = triangleAt_.normal();
    if (std::abs(glm::dot(normal, middle - corner_)) > glm::dot(glm::abs(normal), half)) {
      return false;
    }
    return triangleAt_.nearestTo(middle).squared <= glm::dot(half, half);
  }

  double reach_;
  glm::dvec3 low_, high_, corner_;
  DistanceTriangle triangleAt_;
  std::uint32_t triangle_ = 0;
  std::vector<BlockTriangle>* out_ = nullptr;
};

}  // namespace

std::vector<BlockTriangle> touchedBlocks(std::span<const glm::dvec3> positions,
                                         std::span<const TriangleMesh::Triangle> triangles,
                                         double reach) {
  // Chunks of triangles side by side.
  std::vector<std::vector<BlockTriangle>> chunks((triangles.size() + kChunk - 1) / kChunk);
  parallelFor(chunks.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t chunk = begin; chunk < end; ++chunk) {
      const std::size_t last = std::min((chunk + 1) * kChunk, triangles.size());
      for (std::size_t n = chunk * kChunk; n < last; ++n) {
        const auto& t = triangles[n];
        Toucher(positions[t[0]], positions[t[1]], positions[t[2]], reach)
            .run(static_cast<std::uint32_t>(n), chunks[chunk]);
      }
    }
  });

  // All together, by block.
  std::vector<BlockTriangle> pairs;
  std::size_t count = 0;
  for (const auto& chunk : chunks) count += chunk.size();
  pairs.reserve(count);
  for (const auto& chunk : chunks) pairs.insert(pairs.end(), chunk.begin(), chunk.end());
  std::sort(pairs.begin(), pairs.end(), [](const BlockTriangle& a, const BlockTriangle& b) {
    return a.block != b.block ? a.block < b.block : a.triangle < b.triangle;
  });
  return pairs;
}

}  // namespace bozzetto
