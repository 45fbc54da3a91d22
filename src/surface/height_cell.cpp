// A cell where depth jumps: extra rays find where the nearer clay ends, and walls stand in for what
// lies along the rays there, where no other cloth shows it because something stands before it.
//
// Points are numbered a · 5 + b, a quarters along u and b along v; corners 2 · (a = 4) + (b = 4).
#include <algorithm>
#include <bitset>
#include <cmath>
#include <map>

#include "surface/height_mesh.hpp"

namespace bozzetto {
namespace {

constexpr int kRow = kFine + 1, kCount = kRow * kRow;
constexpr std::int32_t kWallStep = 6;  // cells between the rows of a wall
// Walls lean into the clay by so many cells, so that they do not fight with what is shown.
constexpr float kLean = .25f;

HeightPoint between(const HeightPoint& a, const HeightPoint& b, float t) {
  const auto mix = [t](auto x, auto y) { return float(x) + (float(y) - float(x)) * t; };
  HeightPoint result;
  const PatchVertex &from = a.vertex, &to = b.vertex;
  for (std::size_t n = 0; n < 3; ++n)
    result.vertex.position[n] = mix(from.position[n], to.position[n]);
  const auto first = octahedralNormal(from.normal), last = octahedralNormal(to.normal);
  result.vertex.normal =
      packedNormal(mix(first[0], last[0]), mix(first[1], last[1]), mix(first[2], last[2]));
  for (std::size_t n = 0; n < 4; ++n)
    result.vertex.colour[n] = std::uint8_t(mix(from.colour[n], to.colour[n]) + .5f);
  result.depth = a.depth + (b.depth - a.depth) * double(t);
  result.near = a.near;
  return result;
}

class FineCell {
 public:
  FineCell(PieceMaker& maker, FinePlace place, const std::array<HeightPoint, 4>& corners)
      : maker_(maker), place_(place), corners_(corners) {}
  void run();

 private:
  using Column = std::vector<std::uint16_t>;  // vertices under a point, from the cloth down
  struct Side {
    int from, to;     // corners
    int first, step;  // points
  };

  FinePlace placeOf(int n) const { return {place_[0] + n / kRow, place_[1] + n % kRow}; }
  HeightPoint cast(int n, std::initializer_list<int> corners);
  void fillSide(const Side& side);
  void fill();
  void quad(int a, int b);
  void triangle(int a, int b, int c);
  std::uint16_t numberOf(int n);
  void addNeighbours(const Side& side);
  Column& columnOf(int n);
  void wall(int a, int b);

  PieceMaker& maker_;
  FinePlace place_;
  const std::array<HeightPoint, 4>& corners_;
  std::array<HeightPoint, kCount> points_;
  std::map<int, std::uint16_t> numbers_;
  std::map<int, Column> columns_;
  std::array<std::bitset<kCount>, kCount> edges_;  // of triangles, as they run round them

  // Counter-clockwise in (u, v), so that triangles inside lie on the left.
  static constexpr std::array<Side, 4> kSides{
      {{0, 2, 0, kRow}, {2, 3, kRow* kFine, 1}, {3, 1, kCount - 1, -kRow}, {1, 0, kFine, -1}}};
};

// An extra ray: it meets nothing before the nearest of the whole rays round it does.
HeightPoint FineCell::cast(int n, std::initializer_list<int> corners) {
  std::int32_t first = kNoDepth, last = std::numeric_limits<std::int32_t>::min();
  for (const int corner : corners) {
    const HeightPoint& point = corners_[std::size_t(corner)];
    if (!point.hit()) continue;
    first = std::min(first, point.near);
    last = std::max(last, point.near + kBeyond);
  }
  return first == kNoDepth ? HeightPoint{} : maker_.cast(placeOf(n), first, last);
}

// Where depth does not jump points lie on the line that the neighbouring cell draws; where it does
// both cells cast the same rays.
void FineCell::fillSide(const Side& side) {
  const HeightPoint &from = corners_[std::size_t(side.from)], &to = corners_[std::size_t(side.to)];
  points_[std::size_t(side.first)] = from;
  for (int m = 1; m < kFine; ++m) {
    const int n = side.first + m * side.step;
    HeightPoint& point = points_[std::size_t(n)];
    if (parted(from, to)) {
      point = cast(n, {side.from, side.to});
    } else if (from.hit()) {
      point = between(from, to, float(m) / kFine);
    }
  }
}

void FineCell::fill() {
  for (const Side& side : kSides) fillSide(side);
  for (int a = 1; a < kFine; ++a)
    for (int b = 1; b < kFine; ++b)
      points_[std::size_t(a * kRow + b)] = cast(a * kRow + b, {0, 1, 2, 3});
}

std::uint16_t FineCell::numberOf(int n) {
  const auto [at, isNew] = numbers_.try_emplace(n);
  if (isNew) at->second = maker_.add(points_[std::size_t(n)].vertex);
  return at->second;
}

void FineCell::triangle(int a, int b, int c) {
  const auto p = [&](int n) -> const HeightPoint& { return points_[std::size_t(n)]; };
  if (!joined(p(a), p(b)) || !joined(p(b), p(c)) || !joined(p(c), p(a))) return;
  maker_.triangle(numberOf(a), numberOf(b), numberOf(c));
  for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, a}})
    edges_[std::size_t(from)].set(std::size_t(to));
}

// Cut along the diagonal that spans less depth, or beside the corner that stands apart.
void FineCell::quad(int a, int b) {
  const int first = a * kRow + b;
  const std::array<int, 4> n{first, first + kRow, first + kRow + 1, first + 1};
  const auto span = [&](int from, int to) {
    const HeightPoint &p = points_[std::size_t(from)], &q = points_[std::size_t(to)];
    return joined(p, q) ? std::abs(p.depth - q.depth) : 1e9;
  };
  const std::size_t shift = span(n[0], n[2]) <= span(n[1], n[3]) ? 0 : 1;
  triangle(n[shift], n[shift + 1], n[shift + 2]);
  triangle(n[shift], n[shift + 2], n[(shift + 3) % 4]);
}

// Where depth does not jump the neighbour's triangles come to this side; where it does they may,
// and a wall too many stands inside the clay.
void FineCell::addNeighbours(const Side& side) {
  const HeightPoint& from = corners_[std::size_t(side.from)];
  if (!from.hit() || parted(from, corners_[std::size_t(side.to)])) return;
  for (int m = 0; m < kFine; ++m) {
    const int n = side.first + m * side.step;
    edges_[std::size_t(n + side.step)].set(std::size_t(n));
  }
}

// The clay under a point: to where it ends, or for the length of a wall.
FineCell::Column& FineCell::columnOf(int n) {
  const auto [at, isNew] = columns_.try_emplace(n);
  Column& column = at->second;
  if (!isNew) return column;
  const std::int32_t near = points_[std::size_t(n)].near;
  column.push_back(numberOf(n));
  const auto row = [&](std::int32_t depth) {
    PatchVertex vertex = maker_.passing(placeOf(n), depth).vertex;
    const auto normal = octahedralNormal(vertex.normal);
    for (const Axis axis : {maker_.frame().u(), maker_.frame().v()}) {
      const auto side = std::size_t(index(axis));
      vertex.position[side] -= normal[side] * kLean;
    }
    column.push_back(maker_.add(vertex));
  };
  std::int32_t depth = near + 1;
  for (; depth < near + kWall && maker_.inside(placeOf(n), depth); ++depth)
    if ((depth - near) % kWallStep == 0) row(depth);
  row(depth);
  return column;
}

// Along an edge with triangles on its left and none on its right.
void FineCell::wall(int a, int b) {
  const Column &from = columnOf(a), &to = columnOf(b);
  const std::size_t rows = std::max(from.size(), to.size());
  const auto at = [](const Column& column, std::size_t row) {
    return column[std::min(row, column.size() - 1)];
  };
  for (std::size_t row = 0; row + 1 < rows; ++row) {
    maker_.triangle(at(to, row), at(from, row), at(from, row + 1));
    maker_.triangle(at(to, row), at(from, row + 1), at(to, row + 1));
  }
}

void FineCell::run() {
  fill();
  for (int a = 0; a < kFine; ++a)
    for (int b = 0; b < kFine; ++b) quad(a, b);
  for (const Side& side : kSides) addNeighbours(side);
  for (int a = 0; a < kCount; ++a)
    for (int b = 0; b < kCount; ++b)
      if (edges_[std::size_t(a)][std::size_t(b)] && !edges_[std::size_t(b)][std::size_t(a)])
        wall(a, b);
}

}  // namespace

void meshFineCell(PieceMaker& maker, FinePlace place, const std::array<HeightPoint, 4>& corners) {
  FineCell(maker, place, corners).run();
}

}  // namespace bozzetto
