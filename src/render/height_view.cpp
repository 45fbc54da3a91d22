#include "bozzetto/render/height_view.hpp"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace bozzetto {
namespace {

constexpr double kLeastSlant = .1;  // sides seen under less than 6 degrees are left out
constexpr float kStale = 2;         // cells

// The ray of a piece that a vertex is nearest to. Pieces count from a ray at 0 on two axes, and
// from elsewhere on the third.
int rayOf(const glm::vec3& position, Axis axis, int rays) {
  const int u = (index(axis) + 1) % 3, v = (index(axis) + 2) % 3;
  return int(std::lround(position[u])) * rays + int(std::lround(position[v]));
}

// The axis on which a piece's origin is no multiple of 8.
Axis axisOf(Key origin) { return origin.i & 7 ? Axis::x : origin.j & 7 ? Axis::y : Axis::z; }

// Vertices of cloths by the block they are in: light is looked for block by block.
class Scattered {
 public:
  void add(const UnpackedPatch& patch, std::size_t vertex, VertexLight& light);
  void ask(const OcclusionVolume& volume, double reach, LightDetail detail);

 private:
  struct Block {
    std::vector<glm::vec3> positions, normals;
    std::vector<VertexLight*> lights;
  };
  std::map<Key, Block> blocks_;
};

void Scattered::add(const UnpackedPatch& patch, std::size_t vertex, VertexLight& light) {
  constexpr float side = 8;
  const glm::vec3 at = patch.positions[vertex];
  Key origin = patch.origin;
  glm::vec3 local;
  for (const Axis axis : kAxes) {
    const int a = index(axis);
    const std::int32_t past = origin[axis] & (int(side) - 1);
    const float block = std::floor((at[a] + float(past)) / side) * side;
    origin[axis] += std::int32_t(block) - past;
    local[a] = at[a] + float(past) - block;
  }
  Block& block = blocks_[origin];
  block.positions.push_back(local);
  block.normals.push_back(patch.normals[vertex]);
  block.lights.push_back(&light);
}

void Scattered::ask(const OcclusionVolume& volume, double reach, LightDetail detail) {
  std::vector<PatchVertices> views;
  for (const auto& [origin, block] : blocks_)
    views.push_back({origin, block.positions, block.normals, {}, {}, {}});
  const auto lights = lightOf(volume, views, reach, detail);
  auto found = lights.begin();
  for (const auto& [origin, block] : blocks_) {
    for (std::size_t n = 0; n < block.lights.size(); ++n) *block.lights[n] = (*found)[n];
    ++found;
  }
}

UnpackedPatch patchOf(const HeightPiece& piece) {
  UnpackedPatch patch(piece.origin, piece.vertices, piece.indices);
  patch.fineness = Fineness::heights;
  return patch;
}

}  // namespace

std::vector<Facing> allFacings() {
  std::vector<Facing> all;
  for (const Axis axis : kAxes)
    for (const auto from : {Facing::From::above, Facing::From::below}) all.push_back({axis, from});
  return all;
}

std::vector<Facing> facingsFor(const Camera& camera, const CellBounds& bounds) {
  std::vector<Facing> needed;
  for (const Facing& facing : allFacings()) {
    const double sign = facing.from == Facing::From::above ? 1 : -1;
    double slant = -1;
    for (int corner = 0; corner < 8; ++corner) {
      const glm::bvec3 upper(corner & 4, corner & 2, corner & 1);
      const glm::dvec3 towards = camera.projection == Projection::perspective
                                     ? camera.eye() - glm::mix(bounds.low, bounds.high, upper)
                                     : camera.worldFromView()[2];
      slant = std::max(slant, sign * towards[index(facing.axis)] / glm::length(towards));
    }
    if (slant > kLeastSlant) needed.push_back(facing);
  }
  return needed;
}

std::vector<UnpackedPatch> clothPatches(const Clay& clay, std::vector<Facing> facings,
                                        const OcclusionVolume& volume, double reach) {
  std::vector<UnpackedPatch> patches;
  for (const HeightPiece& piece : HeightField(std::move(facings)).rebuild(clay).pieces) {
    UnpackedPatch& patch = patches.emplace_back(patchOf(piece));
    patch.light.resize(patch.positions.size());
  }
  Scattered dark;
  for (UnpackedPatch& patch : patches)
    for (std::size_t n = 0; n < patch.positions.size(); ++n) dark.add(patch, n, patch.light[n]);
  dark.ask(volume, reach, LightDetail::good);
  return patches;
}

void HeightSwitch::meshed(std::size_t blocks, double milliseconds) {
  if (blocks == 0) return;
  perBlock_ = milliseconds / double(blocks);
  slow_ = milliseconds > tooLong_ ? slow_ + 1 : 0;
  quick_ = 0;
  wantsCloths_ = slow_ >= 2;
}

void HeightSwitch::draped(std::size_t blocks) {
  quick_ = perBlock_ * double(blocks) < little_ ? quick_ + 1 : 0;
  if (quick_ < 4) return;
  wantsCloths_ = false;
  slow_ = 0;
}

std::vector<UnpackedPatch> HeightView::rebuild(const Clay& clay, const OcclusionVolume& volume) {
  lit_.clear();
  report_ = field_.rebuild(clay);
  return dress(volume);
}

std::vector<UnpackedPatch> HeightView::refresh(const Clay& clay, const OcclusionVolume& volume,
                                               std::span<const KeyRun> changed) {
  report_ = field_.refresh(clay, changed);
  return dress(volume);
}

// Asks for light where none was or where the surface has gone, and hands out what there is.
std::vector<UnpackedPatch> HeightView::dress(const OcclusionVolume& volume) {
  std::vector<UnpackedPatch> patches;
  Scattered dark;
  for (const HeightPiece& piece : report_.pieces) {
    const UnpackedPatch& patch = patches.emplace_back(patchOf(piece));
    LitRays& lit = lit_[piece.origin];
    std::bitset<kRays * kRays> seen;  // the first vertex of a ray speaks for all
    for (std::size_t n = 0; n < patch.positions.size(); ++n) {
      const glm::vec3 at = patch.positions[n];
      const auto ray = std::size_t(rayOf(at, axisOf(piece.origin), kRays));
      if (seen[ray]) continue;
      seen.set(ray);
      Lit& known = lit[ray];
      if (known.known && glm::distance(known.position, at) < kStale) continue;
      known = {at, {}, true};
      dark.add(patch, n, known.light);
    }
  }
  dark.ask(volume, reach_, LightDetail::quick);
  for (UnpackedPatch& patch : patches) {
    const LitRays& lit = lit_[patch.origin];
    for (const glm::vec3& at : patch.positions)
      patch.light.push_back(lit[std::size_t(rayOf(at, axisOf(patch.origin), kRays))].light);
  }
  return patches;
}

}  // namespace bozzetto
