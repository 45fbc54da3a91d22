#include "clay/clay_fixture.hpp"

#include <algorithm>
#include <map>

namespace bozzetto::clay::testing {
namespace {

// Dense copy: what measuring needs is simple there.
struct Dense {
  KeyBox box;
  std::vector<float> value;
  std::int64_t nj, nk;
  explicit Dense(const Clay& clay) : box(grown(statistics(clay).bounds, 3)) {
    nj = box.high.j - box.low.j + 1;
    nk = box.high.k - box.low.k + 1;
    value.assign(static_cast<std::size_t>(box.count()), 0);
    for (const auto& [key, run] : clay.tree)
      for (std::int32_t n = 0; n < run.length * 512; ++n) {
        const Key corner = key * 8 + Key{n / 64 % 8, n / 8 % 8, n % 8 + n / 512 * 8};
        if (box.contains(corner)) value[at(corner)] = run.block->value[n % 512];
      }
  }
  std::size_t at(Key key) const {
    const Key local = key - box.low;
    return static_cast<std::size_t>((local.i * nj + local.j) * nk + local.k);
  }
};

// How many cells each piece has.
std::vector<int> sizesOfPieces(const Dense& d, float iso) {
  std::vector<std::uint8_t> seen(d.value.size(), 0);
  std::vector<std::size_t> open;
  const std::ptrdiff_t steps[6] = {1, -1, d.nk, -d.nk, d.nj * d.nk, -d.nj * d.nk};
  std::vector<int> sizes;
  for (std::size_t n = 0; n < seen.size(); ++n) {
    if (seen[n] != 0 || d.value[n] < iso) continue;
    sizes.push_back(0);
    open.push_back(n);
    seen[n] = 1;
    while (!open.empty()) {
      const std::size_t cell = open.back();
      open.pop_back();
      ++sizes.back();
      for (const std::ptrdiff_t step : steps) {
        const std::size_t next = cell + step;
        if (seen[next] != 0 || d.value[next] < iso) continue;
        seen[next] = 1;
        open.push_back(next);
      }
    }
  }
  return sizes;
}

// Part of a cell's cube inside iso, by 27 trilinear samples.
double insideOf(const Dense& d, std::size_t n, float iso) {
  float corner[8];
  int full = 0;
  for (std::size_t c = 0; c < 8; ++c) {
    corner[c] = d.value[n + (c & 1) + (c >> 1 & 1) * d.nk + (c >> 2) * d.nj * d.nk];
    full += corner[c] >= iso ? 1 : 0;
  }
  if (full == 0 || full == 8) return full / 8;
  int count = 0;
  for (int s = 0; s < 27; ++s) {
    const auto third = [](int place) { return (static_cast<float>(place) + 0.5f) / 3; };
    const float z = third(s % 3), y = third(s / 3 % 3), x = third(s / 9);
    float v = 0;
    for (int c = 0; c < 8; ++c)
      v += corner[c] * ((c & 1) != 0 ? z : 1 - z) * ((c & 2) != 0 ? y : 1 - y) *
           ((c & 4) != 0 ? x : 1 - x);
    count += v >= iso ? 1 : 0;
  }
  return count / 27.0;
}

double meanThickness(const Dense& d, float iso) {
  const std::ptrdiff_t steps[3] = {d.nj * d.nk, d.nk, 1};
  double sum = 0, count = 0;
  const auto slope = [&](std::size_t n) {
    glm::dvec3 g;
    for (int a = 0; a < 3; ++a) g[a] = 0.5 * (d.value[n + steps[a]] - d.value[n - steps[a]]);
    return g;
  };
  const std::size_t rim = 2 * (d.nj * d.nk + d.nk + 1);
  for (std::size_t n = rim; n + rim < d.value.size(); ++n)
    for (const std::ptrdiff_t step : steps) {
      const float a = d.value[n], b = d.value[n + step];
      if ((a >= iso) == (b >= iso)) continue;
      const double t = (iso - a) / (b - a);
      const glm::dvec3 g = slope(n) * (1 - t) + slope(n + step) * t;
      sum += 1 / std::max(1e-3, std::sqrt(g.x * g.x + g.y * g.y + g.z * g.z));
      ++count;
    }
  return count > 0 ? sum / count : 0;
}

}  // namespace

Measures measure(const Clay& clay) {
  Measures result;
  result.mass = statistics(clay).mass;
  result.stored = statistics(clay).corners;
  if (result.stored == 0) return result;
  const Dense d(clay);
  const float iso = clay.scale.iso;
  result.densest = *std::max_element(d.value.begin(), d.value.end());
  for (std::size_t n = 0; n < d.value.size(); ++n) {
    const double v = d.value[n];
    if (v <= 0) continue;
    result.faint += v < 0.05 ? 1 : 0;
    const auto key = static_cast<std::int64_t>(n);
    result.centre += v * glm::dvec3(key / (d.nj * d.nk) + d.box.low.i,
                                    key / d.nk % d.nj + d.box.low.j, key % d.nk + d.box.low.k);
  }
  result.centre /= result.mass;
  for (std::size_t n = 0; n + d.nj * d.nk + d.nk + 1 < d.value.size(); ++n)
    result.volume += insideOf(d, n, iso);
  result.pieces = static_cast<int>(sizesOfPieces(d, iso).size());
  result.thickness = meanThickness(d, iso);
  return result;
}

int piecesBelow(const Clay& clay, int cells) {
  int count = 0;
  for (const int size : sizesOfPieces(Dense(clay), clay.scale.iso)) count += size < cells ? 1 : 0;
  return count;
}

std::int64_t cleanCorners(const Clay& clay) {
  const Dense d(clay);
  const float iso = clay.scale.iso;
  const std::size_t rim = d.nj * d.nk + d.nk + 1;
  std::int64_t count = 0;
  for (std::size_t n = rim; n + rim < d.value.size(); ++n) {
    bool near = false;
    for (std::ptrdiff_t c = 0; c < 27 && !near; ++c)
      near = d.value[n + (c / 9 - 1) * d.nj * d.nk + (c / 3 % 3 - 1) * d.nk + c % 3 - 1] >= iso;
    count += near ? 1 : 0;
  }
  return count;
}

std::int64_t run(Clay& clay, const Push& push, Stiffness* moved) {
  Edit<CornerBlock<8>> edit(clay.tree);
  ClayStroke<8> stroke(edit, clay.scale, push.tool, {push.role, push.strength}, push.stroke,
                       push.setup);
  for (std::int64_t n = 0; n < stroke.stepCount(); ++n) stroke.step(n);
  stroke.finish();
  stroke.store();
  edit.commit();
  if (moved != nullptr) *moved = stroke.stiffness();
  return stroke.stepCount();
}

}  // namespace bozzetto::clay::testing
