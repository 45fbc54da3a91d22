#include "ui/patch_set.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace bozzetto::ui {
namespace {

constexpr int kPatchCells = 8, kChunkCells = 64;
constexpr int kMostSteps = 1 << 17;  // chunks along one ray

int floorDiv(std::int32_t value, int by) { return value >= 0 ? value / by : ~(~value / by); }

Key divided(Key key, int by) {
  return {floorDiv(key.i, by), floorDiv(key.j, by), floorDiv(key.k, by)};
}

glm::dvec3 place(Key key) { return {key.i, key.j, key.k}; }

struct Range {
  double from, to;
  bool empty() const { return from > to; }
};

// Where the ray is inside the box.
Range insideOf(const Ray& ray, const glm::dvec3& low, const glm::dvec3& high) {
  Range range{0, HUGE_VAL};
  for (int axis = 0; axis < 3; ++axis) {
    const double d = ray.direction[axis], a = low[axis] - ray.origin[axis],
                 b = high[axis] - ray.origin[axis];
    if (std::abs(d) < 1e-12) {
      if (a > 0 || b < 0) return {1, 0};
      continue;
    }
    range.from = std::max(range.from, std::min(a / d, b / d));
    range.to = std::min(range.to, std::max(a / d, b / d));
  }
  return range;
}

// Amanatides and Woo: the cells of a grid along a ray, in order. Stops when `visit` says true.
template <class Visit>
void walk(const Ray& ray, Range range, double cell, const Visit& visit) {
  const glm::dvec3 start = (ray.origin + ray.direction * range.from) / cell;
  glm::dvec3 next(HUGE_VAL), step(HUGE_VAL);
  std::array<std::int32_t, 3> at{}, way{};
  for (int axis = 0; axis < 3; ++axis) {
    const double d = ray.direction[axis] / cell;
    at[axis] = std::int32_t(std::floor(start[axis]));
    if (d == 0) continue;
    way[axis] = d > 0 ? 1 : -1;
    step[axis] = std::abs(1 / d);
    const double edge = at[axis] + (d > 0 ? 1 : 0);
    next[axis] = range.from + (edge - start[axis]) / d;
  }
  for (int n = 0; n < kMostSteps; ++n) {
    if (visit(Key{at[0], at[1], at[2]})) return;
    const int axis = next.x < next.y ? (next.x < next.z ? 0 : 2) : (next.y < next.z ? 1 : 2);
    if (next[axis] > range.to) return;
    at[axis] += way[axis];
    next[axis] += step[axis];
  }
}

struct Crossing {
  double distance;
  double u, v;
};

// Möller and Trumbore, front faces only.
std::optional<Crossing> cross(const Ray& ray, const glm::dvec3& a, const glm::dvec3& b,
                              const glm::dvec3& c) {
  const glm::dvec3 ab = b - a, ac = c - a, p = glm::cross(ray.direction, ac);
  const double det = glm::dot(ab, p);
  if (det <= 1e-14) return std::nullopt;
  const glm::dvec3 t = ray.origin - a, q = glm::cross(t, ab);
  const double u = glm::dot(t, p) / det, v = glm::dot(ray.direction, q) / det;
  const double distance = glm::dot(ac, q) / det;
  constexpr double kRim = -1e-7;  // neighbours overlap a little: no ray slips between
  if (u < kRim || v < kRim || u + v > 1 - kRim || distance < 0) return std::nullopt;
  return Crossing{distance, u, v};
}

void pickIn(const ShownPatch& patch, const Ray& ray, std::optional<SurfaceHit>& best) {
  const UnpackedPatch& data = patch.data;
  const Ray local{ray.origin - place(data.origin), ray.direction};
  for (std::size_t n = 0; n + 2 < data.indices.size(); n += 3) {
    const std::uint16_t a = data.indices[n], b = data.indices[n + 1], c = data.indices[n + 2];
    const auto hit = cross(local, data.positions[a], data.positions[b], data.positions[c]);
    if (!hit || (best && hit->distance >= best->distance)) continue;
    const double u = hit->u, v = hit->v, w = 1 - u - v;
    const glm::dvec3 normal = glm::dvec3(data.normals[a]) * w + glm::dvec3(data.normals[b]) * u +
                              glm::dvec3(data.normals[c]) * v;
    best = SurfaceHit{ray.origin + ray.direction * hit->distance, glm::normalize(normal),
                      hit->distance,
                      data.colours[w > u && w > v ? a
                                   : u > v        ? b
                                                  : c]};
  }
}

std::size_t trianglesOf(const PatchRef& patch) {
  return patch ? patch->data.indices.size() / 3 : 0;
}

}  // namespace

std::size_t PatchSet::Hash::operator()(Key key) const {
  const std::uint64_t row = std::uint64_t(std::uint32_t(key.i)) << 32 | std::uint32_t(key.j);
  return std::size_t((row ^ std::uint64_t(std::uint32_t(key.k)) * 0x9e3779b97f4a7c15u) *
                     0xd6e8feb86659fd93u);
}

void PatchSet::Chunk::measure() {
  bounds = {};
  for (const PatchRef& patch : patches)
    if (patch) bounds.add(patch->bounds);
}

void PatchSet::put(Key origin, PatchRef patch) {
  if (const auto old = loose_.find(origin); old != loose_.end()) {
    triangles_ -= trianglesOf(old->second);
    loose_.erase(old);
  }
  const bool loose = patch && patch->lies == Lies::anywhere;
  putInChunk(origin, loose ? nullptr : patch);
  bounds_.reset();
  if (!loose) return;
  triangles_ += trianglesOf(patch);
  loose_[origin] = std::move(patch);
}

void PatchSet::putInChunk(Key origin, PatchRef patch) {
  const Key block = divided(origin, kPatchCells), key = divided(block, kSide);
  const Key local = block - key * kSide;
  std::shared_ptr<Chunk>& slot = chunks_[key];
  if (!slot) slot = std::make_shared<Chunk>();
  if (slot.use_count() > 1) slot = std::make_shared<Chunk>(*slot);
  PatchRef& old = slot->patches[std::size_t((local.i * kSide + local.j) * kSide + local.k)];
  triangles_ += trianglesOf(patch) - trianglesOf(old);
  slot->count += (patch ? 1 : 0) - (old ? 1 : 0);
  old = std::move(patch);
  slot->measure();
  if (slot->count == 0) chunks_.erase(key);
}

void PatchSet::clear() {
  chunks_.clear();
  loose_.clear();
  triangles_ = 0;
  bounds_.reset();
}

const CellBounds& PatchSet::bounds() const {
  if (bounds_) return *bounds_;
  bounds_.emplace();
  for (const auto& [key, chunk] : chunks_) bounds_->add(chunk->bounds);
  for (const auto& [key, patch] : loose_) bounds_->add(patch->bounds);
  return *bounds_;
}

std::vector<CellBounds> PatchSet::boxes() const {
  std::vector<CellBounds> boxes;
  for (const auto& [key, chunk] : chunks_) boxes.push_back(chunk->bounds);
  for (const auto& [key, patch] : loose_) boxes.push_back(patch->bounds);
  return boxes;
}

std::optional<SurfaceHit> PatchSet::pickIn(const Chunk& chunk, Key first, const Ray& ray) const {
  const glm::dvec3 low = place(first * kChunkCells);
  const Ray local{ray.origin - low, ray.direction};
  const Range range = insideOf(local, glm::dvec3(0), glm::dvec3(kChunkCells));
  std::optional<SurfaceHit> best;
  if (range.empty()) return best;
  walk(local, range, kPatchCells, [&](Key at) {
    if (std::min({at.i, at.j, at.k}) < 0 || std::max({at.i, at.j, at.k}) >= kSide) return false;
    const PatchRef& patch = chunk.patches[std::size_t((at.i * kSide + at.j) * kSide + at.k)];
    if (patch) ui::pickIn(*patch, ray, best);
    return best.has_value();
  });
  return best;
}

std::optional<SurfaceHit> PatchSet::pick(const Ray& ray) const {
  const CellBounds& all = bounds();
  std::optional<SurfaceHit> best;
  if (all.empty()) return best;
  const Range range = insideOf(ray, all.low - 1.0, all.high + 1.0);
  if (range.empty()) return best;
  walk(ray, range, kChunkCells, [&](Key at) {
    const auto found = chunks_.find(at);
    if (found != chunks_.end()) best = pickIn(*found->second, at, ray);
    return best.has_value();
  });
  for (const auto& [key, patch] : loose_) {
    const CellBounds& box = patch->bounds;
    if (!insideOf(ray, box.low - 1e-3, box.high + 1e-3).empty()) ui::pickIn(*patch, ray, best);
  }
  return best;
}

}  // namespace bozzetto::ui
