#include "bozzetto/solid/bake.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "bozzetto/base/error.hpp"
#include "bozzetto/base/parallel.hpp"
#include "bozzetto/solid/boundary.hpp"
#include "bozzetto/solid/refine.hpp"
#include "solid/columns.hpp"
#include "solid/raise.hpp"
#include "solid/surface_blocks.hpp"
#include "solid/triangle_rows.hpp"

namespace bozzetto {
namespace {

constexpr double kReach = 1;   // half the slope, in cells
constexpr double kFlat = 0.1;  // of the pieces of a twisted quad, in cells
constexpr int kMostCuts = 16;
constexpr std::size_t kMostBlocks = std::size_t{1} << 23;
constexpr std::size_t kBatch = 2048;

// Enough pieces for every quad to be flat: a fan leaves a bilinear quad by a sixteenth of its
// twist.
int cutsFor(const Lattice& surface, double spacing) {
  double worst = 0;
  for (Id face = 0; face < surface.faces.size(); ++face) {
    const auto q = surface.faces[face];
    if (q.size() != 4) continue;
    const auto& p = surface.points;
    worst = std::max(worst, glm::length(p[q[0]] - p[q[1]] + p[q[2]] - p[q[3]]));
  }
  const double cuts = std::ceil(std::sqrt(worst / spacing / 16 / kFlat));
  return static_cast<int>(std::clamp(cuts, 1.0, double(kMostCuts)));
}

// The surface in cells, counted from the first corner of a block below all of it.
struct CellMesh {
  TriangleMesh mesh;
  Key firstBlock, size;

  CellMesh(TriangleMesh triangles, double spacing) : mesh(std::move(triangles)) {
    glm::dvec3 low = mesh.positions[0] / spacing, high = low;
    for (auto& p : mesh.positions) {
      p /= spacing;
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
    KeyBox box;
    for (const Axis axis : kAxes) {
      const int a = index(axis);
      if (!(low[a] > -kWorkspaceRim + 16.0 && high[a] < kWorkspaceRim - 16.0))
        throw Error("bake: found a solid that reaches beyond the workspace, expected one inside");
      box.low[axis] = static_cast<std::int32_t>(std::floor(low[a] - kReach));
      box.high[axis] = static_cast<std::int32_t>(std::ceil(high[a] + kReach));
    }
    firstBlock = BlockGeometry<8>::blockOf(box.low);
    const Key origin = BlockGeometry<8>::firstCornerOf(firstBlock);
    size = box.high - origin + Key{1, 1, 1};
    for (auto& p : mesh.positions) p -= glm::dvec3(origin.i, origin.j, origin.k);
    requireAffordable();
  }

 private:
  void requireAffordable() const {
    double area = 0;
    for (const auto& t : mesh.triangles) {
      const auto& a = mesh.positions[t[0]];
      area += glm::length(glm::cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a)) / 2;
    }
    const double columns = double(size.i) * double(size.j);
    const bool isShort = std::max({size.i, size.j, size.k}) < 1 << 24;
    if (area / 16 <= double(kMostBlocks) && columns <= 64.0 * kMostBlocks && isShort) return;
    throw Error("bake: found a surface of about " + std::to_string(area / 16) +
                " blocks, expected at most 2^23: use a larger spacing");
  }
};

struct Task {
  Key block;
  std::span<const NearTriangle> triangles;
};

std::vector<Task> tasksOf(std::span<const NearTriangle> pairs) {
  std::vector<Task> tasks;
  for (std::size_t first = 0; first < pairs.size();) {
    std::size_t last = first;
    while (last < pairs.size() && pairs[last].code == pairs[first].code) ++last;
    tasks.push_back({pairs[first].block(), pairs.subspan(first, last - first)});
    first = last;
  }
  return tasks;
}

class Densities {
 public:
  Densities(const CellMesh& cells, const Columns& columns) : cells_(cells), columns_(columns) {}

  void compute(const Task& task, WantedDensities& wanted) const {
    SquaredDistances squared;
    squared.fill(static_cast<float>(kReach * kReach));
    const Key first = task.block * 8;
    const glm::dvec3 origin(first.i, first.j, first.k);
    for (const NearTriangle& near : task.triangles) measure(near.triangle, origin, squared);
    for (int n = 0; n < 512; ++n) {
      const Key corner = first + Key{n / 64, n / 8 % 8, n % 8};
      const bool inside = columns_.winding(corner.i, corner.j, corner.k) > 0;
      const float distance = std::sqrt(squared[n]) * (inside ? -1.0f : 1.0f);
      wanted[n] = std::clamp(0.5f - 0.5f * distance, 0.0f, 1.0f);
    }
  }

 private:
  void measure(std::uint32_t number, const glm::dvec3& origin, SquaredDistances& squared) const {
    std::array<glm::vec3, 3> corners;
    for (std::size_t n = 0; n < 3; ++n)
      corners[n] = glm::vec3(cells_.mesh.positions[cells_.mesh.triangles[number][n]] - origin);
    const glm::vec3 low = glm::min(glm::min(corners[0], corners[1]), corners[2]) - 1.0f;
    const glm::vec3 high = glm::max(glm::max(corners[0], corners[1]), corners[2]) + 1.0f;
    if (high.z < 0 || low.z > 7) return;
    const auto from = [](float x) { return std::max(0, static_cast<int>(std::ceil(x))); };
    const auto to = [](float x) { return std::min(7, static_cast<int>(std::floor(x))); };
    lowerDistances(MeasuredTriangle(corners),
                   {{from(low.x), from(low.y), 0}, {to(high.x), to(high.y), 7}}, squared);
  }

  const CellMesh& cells_;
  const Columns& columns_;
};

template <int Side>
class Baker {
 public:
  Baker(Edit<CornerBlock<Side>>& edit, const CellMesh& cells, Attributes colour)
      : edit_(edit),
        cells_(cells),
        columns_(cells.mesh, cells.size.i, cells.size.j),
        colour_(colour) {}

  std::int64_t run(Progress& progress) {
    const auto pairs = nearTriangles(cells_.mesh, kReach);
    const auto tasks = tasksOf(pairs);
    std::int64_t dirty = 0;
    for (std::size_t first = 0; first < tasks.size(); first += kBatch) {
      progress.step("bake", double(first) / double(tasks.size()));
      dirty += batch(std::span(tasks).subspan(first, std::min(kBatch, tasks.size() - first)));
    }
    for (std::size_t n = 1; n < tasks.size(); ++n)
      dirty += between(tasks[n - 1].block, tasks[n].block);
    return dirty;
  }

 private:
  std::int64_t batch(std::span<const Task> tasks) {
    std::vector<WantedDensities> wanted(tasks.size());
    const Densities densities(cells_, columns_);
    parallelFor(tasks.size(), 8, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) densities.compute(tasks[n], wanted[n]);
    });
    std::int64_t dirty = 0;
    for (std::size_t n = 0; n < tasks.size(); ++n)
      dirty += raise(edit_, tasks[n].block + cells_.firstBlock, wanted[n], colour_);
    return dirty;
  }

  // Blocks between two of a row are all inside or all outside.
  std::int64_t between(Key low, Key high) {
    const std::int32_t length = high.k - low.k - 1;
    if (low.i != high.i || low.j != high.j || length < 1) return 0;
    const Key corner = (low + Key{0, 0, 1}) * 8;
    if (columns_.winding(corner.i, corner.j, corner.k) <= 0) return 0;
    return raiseFull(edit_, {low + Key{0, 0, 1} + cells_.firstBlock, length}, colour_);
  }

  Edit<CornerBlock<Side>>& edit_;
  const CellMesh& cells_;
  Columns columns_;
  Attributes colour_;
};

}  // namespace

template <int Side>
BakeReport bake(Edit<CornerBlock<Side>>& edit, const FieldScale& scale, const Lattice& control,
                const BakeOptions& options, Progress& progress) {
  if (options.levels < 0 || options.levels > 6) {
    throw Error("bake: found " + std::to_string(options.levels) + " levels, expected 0 to 6");
  }
  const Lattice coarse = surfaceOf(control);
  if (double(coarse.faces.itemCount()) * std::pow(4.0, options.levels) > 1 << 23)
    throw Error("bake: found more than 2^23 quads, expected fewer: use fewer levels");
  const Lattice surface = refine(coarse, options.levels).lattice;
  BakeReport report;
  report.volume = enclosedVolume(surface);
  const CellMesh cells(triangulated(surface, cutsFor(surface, scale.spacing)), scale.spacing);
  report.triangles = cells.mesh.triangles.size();
  try {
    report.dirty = Baker<Side>(edit, cells, packAttributes(options.colour)).run(progress);
  } catch (...) {
    edit.rollback();
    throw;
  }
  return report;
}

template BakeReport bake(Edit<CornerBlock<1>>&, const FieldScale&, const Lattice&,
                         const BakeOptions&, Progress&);
template BakeReport bake(Edit<CornerBlock<8>>&, const FieldScale&, const Lattice&,
                         const BakeOptions&, Progress&);

}  // namespace bozzetto
