// OpenVDB has no incremental surface: the leaves under the brush are copied to a grid of their own
// and meshed there. Whole extraction, and what undo by copying costs, stand beside it.
#include <openvdb/tools/VolumeToMesh.h>

#include "cases.hpp"

namespace bozzetto::peer {
namespace {

struct Mesh {
  std::vector<openvdb::Vec3s> points;
  std::vector<openvdb::Vec4I> quads;

  double triangles() const { return 2.0 * static_cast<double>(quads.size()); }
  void addTo(Fingerprint& fingerprint) const {
    for (const auto& p : points) fingerprint.add(p.asPointer(), 3);
    fingerprint.add(static_cast<std::uint32_t>(quads.size()));
  }
};

// How far beyond the brush leaves are taken along: one leaf, or only what its change can reach.
enum class Apron { leaf, tight };

FloatGrid::Ptr copyUnder(const FloatGrid& grid, const Brush& brush, Apron apron) {
  FloatGrid::Ptr part = FloatGrid::create(grid.background());
  auto to = part->getAccessor();
  const auto from = grid.getConstAccessor();
  const double reach = brush.radius + kHalfWidth + (apron == Apron::leaf ? 8 : 1);
  forLeavesWithin(brush.centre, reach, [&](const Coord& origin, const LeafDistance&) {
    if (const Leaf* leaf = from.probeConstLeaf(origin)) {
      to.addLeaf(new Leaf(*leaf));
    } else if (from.getValue(origin) < 0) {
      to.addTile(1, origin, -kHalfWidth, false);
    }
  });
  return part;
}

Mesh remesh(const FloatGrid& grid, const Brush& brush, Apron apron) {
  Mesh mesh;
  openvdb::tools::volumeToMesh(*copyUnder(grid, brush, apron), mesh.points, mesh.quads, 0.0);
  return mesh;
}

// The ball stays as it is: the least surface a dab could leave behind.
Result refresh(const Job& job, Apron apron) {
  Result result = job.result();
  const std::vector<Brush> brushes = strokeOf(job.radius);
  double triangles = 0;
  for (int n = 0; n < job.repeats; ++n) {
    Fingerprint fingerprint;
    double ms = triangles = 0;
    for (const Brush& brush : brushes) {
      const Clock clock;
      const Mesh mesh = remesh(levelSetBall(), brush, apron);
      ms += clock.ms();
      triangles += mesh.triangles();
      mesh.addTo(fingerprint);
    }
    result.ms.push_back(ms / static_cast<double>(brushes.size()));
    result.fingerprint = fingerprint.value();
  }
  result.detail = {{"triangles", triangles / static_cast<double>(brushes.size())}};
  return result;
}

// Copies of the leaves that the brush will write: what an undo step keeps.
std::vector<std::unique_ptr<Leaf>> keepUnder(const FloatGrid& grid, const Brush& brush) {
  std::vector<std::unique_ptr<Leaf>> kept;
  const auto accessor = grid.getConstAccessor();
  const double reach = brush.radius + kHalfWidth;
  forLeavesWithin(brush.centre, reach, [&](const Coord& origin, const LeafDistance&) {
    if (const Leaf* leaf = accessor.probeConstLeaf(origin)) {
      kept.push_back(std::make_unique<Leaf>(*leaf));
    }
  });
  return kept;
}

// Field, surface and undo of one dab, as an editor built on OpenVDB would do them.
Result wholeDab(const Job& job) {
  std::vector<std::vector<std::unique_ptr<Leaf>>> history;
  return measureStroke(
      job, levelSetBall(),
      [&](FloatGrid& grid, const Brush& brush) {
        history.push_back(keepUnder(grid, brush));
        dabLevelSet(grid, brush, Change::add);
        remesh(grid, brush, Apron::tight);
      },
      [&] { history.clear(); });
}

Result wholeMesh(const Job& job) {
  Result result = job.result();
  const FloatGrid& ball = levelSetBall();
  Mesh mesh;
  result.ms = timeRepeats(
      job.repeats, [&] { mesh = {}; },
      [&] { openvdb::tools::volumeToMesh(ball, mesh.points, mesh.quads, 0.0); });
  Fingerprint fingerprint;
  mesh.addTo(fingerprint);
  result.fingerprint = fingerprint.value();
  result.detail = {{"triangles", mesh.triangles()},
                   {"vertices", static_cast<double>(mesh.points.size())}};
  return result;
}

Result snapshot(const Job& job, const FloatGrid& ball) {
  Result result = job.result();
  FloatGrid::Ptr copy;
  result.ms = timeRepeats(
      job.repeats, [&] { copy.reset(); }, [&] { copy = ball.deepCopy(); });
  result.fingerprint = fingerprintOf(*copy);
  addCounts(result, *copy);
  return result;
}

}  // namespace

std::vector<Case> meshCases() {
  return {{"refresh", true, [](const Job& job) { return refresh(job, Apron::leaf); }},
          {"refresh_tight", true, [](const Job& job) { return refresh(job, Apron::tight); }},
          {"whole_dab", true, wholeDab},
          {"mesh", false, wholeMesh},
          {"snapshot", false, [](const Job& job) { return snapshot(job, levelSetBall()); }},
          {"snapshot_fog", false, [](const Job& job) { return snapshot(job, fogBall()); }}};
}

}  // namespace bozzetto::peer
