#include "bozzetto/surface/statistics.hpp"

#include <bit>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numeric>

#include "surface/columns.hpp"
#include "surface/key_runs.hpp"
#include "surface/vertex_numbers.hpp"

namespace bozzetto {
namespace {

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t find(std::size_t n) {
    while (parent_[n] != n) n = parent_[n] = parent_[parent_[n]];
    return n;
  }
  /// Whether the two were apart.
  bool join(std::size_t a, std::size_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

 private:
  std::vector<std::size_t> parent_;
};

template <int Side>
std::int64_t componentCount(const Surface<Side>& surface) {
  const VertexNumbers<Side> numbers(surface);
  DisjointSets sets(numbers.vertexCount());
  auto count = static_cast<std::int64_t>(numbers.vertexCount());
  std::vector<std::size_t> scratch;
  for (const auto& entry : numbers.entries()) {
    numbers.numbersOf(entry, scratch);
    const auto indices = entry.patch->content().indices;
    for (std::size_t n = 0; n + 2 < indices.size(); n += 3) {
      count -= sets.join(scratch[indices[n]], scratch[indices[n + 1]]) ? 1 : 0;
      count -= sets.join(scratch[indices[n]], scratch[indices[n + 2]]) ? 1 : 0;
    }
  }
  return count;
}

template <int Side>
class CubeCounter {
 public:
  explicit CubeCounter(const Columns<Side>& columns) : columns_(columns) {}

  std::int64_t count(const KeyRun& run) {
    columns_.placeAround(run.key.i, run.key.j, cursors_);
    const std::int32_t end = run.key.k + run.length;
    std::int64_t sum = 0;
    for (std::int32_t k = run.key.k; k < end;) {
      const std::int64_t here = countAt(k);
      const std::int32_t next = std::min(end, nextChange(k));
      sum += here * (next - k);
      k = next;
    }
    return sum;
  }

 private:
  static constexpr int kSpan = BlockWindow<Side>::kSpan;
  static constexpr std::array<int, 4> kOwn{kSpan + 1, kSpan + 2, 2 * kSpan + 1, 2 * kSpan + 2};

  std::uint32_t storedRow(int i, int j) const {
    const auto& blocks = cursors_[kOwn[i / Side * 2 + j / Side]].blocks();
    const int at = BlockGeometry<Side>::indexOf(i % Side, j % Side, 0);
    std::uint32_t bits = blocks[2]->value[at] > 0 ? 1u << Side : 0;
    for (int k = 0; k < Side; ++k) bits |= (blocks[1]->value[at + k] > 0 ? 1u : 0u) << k;
    return bits;
  }

  std::int64_t countAt(std::int32_t k) {
    for (const int column : kOwn) cursors_[column].moveTo(k);
    if (cursors_[kOwn[0]].blocks()[1]->low > 0) return Side * Side * Side;
    std::int64_t sum = 0;
    for (int i = 0; i < Side; ++i)
      for (int j = 0; j < Side; ++j) {
        const std::uint32_t bits =
            storedRow(i, j) | storedRow(i, j + 1) | storedRow(i + 1, j) | storedRow(i + 1, j + 1);
        sum += std::popcount((bits | bits >> 1) & ((1u << Side) - 1));
      }
    return sum;
  }

  // Where own and next blocks stay the same, so does the count.
  std::int32_t nextChange(std::int32_t k) const {
    std::int32_t until = ColumnCursor<Side>::kNever;
    for (const int column : kOwn) until = std::min(until, cursors_[column].constantFrom(k));
    return std::max(k + 1, until - 1);
  }

  const Columns<Side>& columns_;
  std::array<ColumnCursor<Side>, kSpan * kSpan> cursors_;
};

template <int Side>
std::int64_t cubeCount(const Field<Side>& field) {
  std::vector<TouchedRun> stored;
  for (const auto& [key, run] : field.tree) stored.push_back({{key, run.length}});
  const Columns<Side> columns(field);
  std::int64_t sum = 0;
  for (const KeyRun& run : dilated(joined(std::move(stored)), 1, 0)) {
    sum += CubeCounter<Side>(columns).count(run);
  }
  return sum;
}

}  // namespace

template <int Side>
SurfaceStatistics statistics(const Surface<Side>& surface, const Field<Side>& field) {
  const SurfaceTotals& totals = surface.totals();
  return {cubeCount(field), totals.crossingCubes, totals.edges, totals.triangles,
          componentCount(surface)};
}

template <int Side>
SurfaceMeasure measure(const Surface<Side>& surface) {
  SurfaceMeasure sum;
  const auto& patches = surface.patches();
  if (patches.begin() == patches.end()) return sum;
  const Key anchor = BlockGeometry<Side>::firstCornerOf((*patches.begin()).first);
  for (const auto& [key, run] : patches) {
    const PatchContent content = run.block->content();
    const Key corner = BlockGeometry<Side>::firstCornerOf(key) - anchor;
    const auto place = [&](std::size_t n) {
      const auto& p = content.vertices[content.indices[n]].position;
      return glm::dvec3(corner.i, corner.j, corner.k) + glm::dvec3(p[0], p[1], p[2]);
    };
    for (std::size_t n = 0; n + 2 < content.indices.size(); n += 3) {
      const glm::dvec3 a = place(n), across = glm::cross(place(n + 1) - a, place(n + 2) - a);
      sum.volume += glm::dot(a, across) / 6;
      sum.area += glm::length(across) / 2;
    }
  }
  return sum;
}

template SurfaceMeasure measure(const Surface<1>&);
template SurfaceMeasure measure(const Surface<8>&);

template SurfaceStatistics statistics(const Surface<1>&, const Field<1>&);
template SurfaceStatistics statistics(const Surface<8>&, const Field<8>&);

}  // namespace bozzetto
