#include "bozzetto/surface/height_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <random>
#include <set>

#include "bozzetto/base/parallel.hpp"
#include "bozzetto/surface/surface.hpp"
#include "surface/surface_fields.hpp"

namespace bozzetto {
namespace {

using testing::ball;
using testing::fieldOf;
using testing::surfaceOf;

std::vector<Facing> everySide() {
  std::vector<Facing> all;
  for (const Axis axis : kAxes)
    for (const auto from : {Facing::From::above, Facing::From::below}) all.push_back({axis, from});
  return all;
}

using Pieces = std::map<Key, HeightPiece>;

void keep(HeightReport report, Pieces& pieces) {
  for (HeightPiece& piece : report.pieces) {
    if (piece.indices.empty()) {
      pieces.erase(piece.origin);
    } else {
      pieces[piece.origin] = std::move(piece);
    }
  }
}

Pieces piecesOf(const Clay& clay, std::vector<Facing> facings = everySide()) {
  HeightField heights(std::move(facings));
  Pieces pieces;
  keep(heights.rebuild(clay), pieces);
  return pieces;
}

// Triangles by their places in the world: names of pieces depend on what was shown first.
using Place = std::array<double, 3>;
std::multiset<std::array<Place, 3>> trianglesOf(const Pieces& pieces) {
  std::multiset<std::array<Place, 3>> all;
  for (const auto& [origin, piece] : pieces) {
    for (std::size_t n = 0; n < piece.indices.size(); n += 3) {
      std::array<Place, 3> triangle;
      for (std::size_t m = 0; m < 3; ++m) {
        const auto& p = piece.vertices[piece.indices[n + m]].position;
        triangle[m] = {double(origin.i) + p[0], double(origin.j) + p[1], double(origin.k) + p[2]};
        for (double& at : triangle[m]) at = std::round(at * 4096) / 4096;
      }
      all.insert(triangle);
    }
  }
  return all;
}

// Changes the values in a box and says which blocks that were.
std::vector<KeyRun> set(Clay& clay, const KeyBox& box, const std::function<float(Key)>& value) {
  return testing::fill<8>(clay, box, value).keys();
}

TEST(HeightField, wholeRaysHaveTheVerticesOfTheMesh) {
  const Clay clay = ball<8>(20.3f, {3, 4, 5});
  std::map<Place, std::pair<std::array<std::int16_t, 2>, std::array<std::uint8_t, 4>>> meshed;
  const auto surface = surfaceOf(clay);
  for (const auto& [block, run] : surface.patches()) {
    const Key corner = Clay::Geometry::firstCornerOf(block);
    for (const PatchVertex& v : run.block->content().vertices)
      meshed[{corner.i + double(v.position[0]), corner.j + double(v.position[1]),
              corner.k + double(v.position[2])}] = {v.normal, v.colour};
  }
  int found = 0;
  for (const auto& [origin, piece] : piecesOf(clay, {{Axis::y, Facing::From::above}})) {
    for (const PatchVertex& v : piece.vertices) {
      const auto at =
          meshed.find({origin.i + double(v.position[0]), origin.j + double(v.position[1]),
                       origin.k + double(v.position[2])});
      if (at == meshed.end()) continue;
      EXPECT_EQ(at->second, std::pair(v.normal, v.colour));
      ++found;
    }
  }
  EXPECT_GT(found, 1150);  // of 1290 rays that meet a disc of this radius; rims differ
}

TEST(HeightField, refreshesLeaveWhatARebuildMakes) {
  std::mt19937 random(5);
  Clay clay = ball<8>(9, {32, 32, 32});  // no depth beyond 64: pieces count from one place
  HeightField heights(everySide());
  Pieces pieces;
  keep(heights.rebuild(clay), pieces);
  for (int step = 0; step < 12; ++step) {
    const auto at = [&] { return std::int32_t(random() % 30) + 14; };
    const Key low{at(), at(), at()};
    const int size = 1 + int(random() % 9), kind = int(random() % 3);
    const auto value = [&](Key) {
      return kind == 0 ? 0.f : kind == 1 ? 1.f : float(random() % 5) / 4;
    };
    std::map<Key, float> values;
    const auto once = [&](Key key) { return values.try_emplace(key, value(key)).first->second; };
    const auto changed = set(clay, {low, low + Key{size, size, size}}, once);
    keep(heights.refresh(clay, changed), pieces);
    ASSERT_EQ(trianglesOf(pieces), trianglesOf(piecesOf(clay))) << "step " << step;
  }
}

// The view's point: rays are cast where the clay they saw has gone, and nowhere else.
TEST(HeightField, costsRaysOnlyWhereTheClayChanged) {
  Clay clay = ball<8>(40, {0, 0, 0});
  HeightField heights({{Axis::z, Facing::From::above}});
  heights.rebuild(clay);
  const auto fill = [](float value) { return [value](Key) { return value; }; };
  // Behind, and deep inside.
  const HeightReport hidden =
      heights.refresh(clay, set(clay, {{-9, -9, -38}, {9, 9, -20}}, fill(0)));
  EXPECT_EQ(hidden.rays + hidden.extraRays + hidden.vertices, 0);
  EXPECT_TRUE(hidden.pieces.empty());
  // In front: what came nearer is known without a ray.
  const HeightReport nearer = heights.refresh(clay, set(clay, {{0, 0, 44}, {9, 9, 47}}, fill(1)));
  EXPECT_EQ(nearer.rays, 0);
  EXPECT_GT(nearer.vertices, 99);
  EXPECT_LT(nearer.vertices, 300);
  // Gone again: as many rays as were covered.
  const HeightReport gone = heights.refresh(clay, set(clay, {{0, 0, 44}, {9, 9, 47}}, fill(0)));
  EXPECT_EQ(gone.rays, 100);
  EXPECT_LT(gone.pieces.size(), 30u);
  EXPECT_EQ(heights.refresh(clay, {}).pieces.size(), 0u);
}

TEST(HeightField, doesNotMergeWhatStandsApart) {
  const auto inside = [](Key key) {
    const bool front = key.k >= 20 && key.k < 24 && key.i < 10;
    return front || (key.k >= 0 && key.k < 4) ? 1.f : 0.f;
  };
  const Clay clay = fieldOf<8>(28, inside);
  for (const auto& [a, b, c] : trianglesOf(piecesOf(clay, {{Axis::z, Facing::From::above}}))) {
    const double low = std::min({a[2], b[2], c[2]}), high = std::max({a[2], b[2], c[2]});
    EXPECT_LT(high - low, 4.5);
    EXPECT_TRUE(high < 5 || low > 18);
  }
}

TEST(HeightField, sidesTogetherShowTheBall) {
  const float radius = 21.4f;
  double area = 0;
  for (const auto& [a, b, c] : trianglesOf(piecesOf(ball<8>(radius, {0, 0, 0})))) {
    const glm::dvec3 p(a[0], a[1], a[2]), q(b[0], b[1], b[2]), r(c[0], c[1], c[2]);
    const glm::dvec3 across = glm::cross(q - p, r - p), middle = (p + q + r) / 3.;
    if (glm::length(across) < 1e-3) continue;
    ASSERT_LT(glm::length(middle), radius + .1);
    if (glm::length(middle) < radius - .1) continue;  // walls, inside
    ASSERT_GT(glm::dot(across, middle), 0);
    area += glm::length(across) / 2;
  }
  EXPECT_GT(area, 4 * 3.14159 * radius * radius);  // they overlap
}

TEST(HeightField, threadsDoNotShow) {
  const Clay clay = ball<8>(25, {1, 2, 3});
  setThreadCount(1);
  const auto one = trianglesOf(piecesOf(clay));
  setThreadCount(0);
  EXPECT_EQ(one, trianglesOf(piecesOf(clay)));
}

}  // namespace
}  // namespace bozzetto
