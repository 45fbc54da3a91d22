#include "surface/height_mesh.hpp"

#include <bit>
#include <cmath>

namespace bozzetto {
namespace {

constexpr int kSide = RayTile::kSide, kPoints = kSide + 1;
constexpr double kJump = 1.6, kApart = 3.2;  // cells of depth: see parted and joined

using Points = std::array<HeightPoint, kPoints * kPoints>;
using Numbers = std::array<int, kPoints * kPoints>;

// The rays of a tile and the first of those above it.
void load(const RaySheet& sheet, TilePlace place, const PieceMaker& maker, Points& points) {
  for (int u = 0; u < kPoints; ++u) {
    for (int v = 0; v < kPoints; ++v) {
      const auto tile = sheet.tiles().find({place.u + u / kSide, place.v + v / kSide});
      if (tile == sheet.tiles().end()) continue;
      const RayTile& rays = tile->second;
      const auto ray = std::size_t(u % kSide * kSide + v % kSide);
      if (rays.near[ray] == kNoDepth) continue;
      points[std::size_t(u * kPoints + v)] =
          maker.point({u * kFine, v * kFine}, rays.near[ray], {rays.vertex[ray], rays.back[ray]});
    }
  }
}

// Corners (0,0) (1,0) (1,1) (0,1), cut along the diagonal that spans less depth.
void meshCell(PieceMaker& maker, const Points& points, Numbers& numbers, int u, int v) {
  std::array<std::size_t, 4> at;
  for (int n = 0; n < 4; ++n)
    at[std::size_t(n)] = std::size_t((u + (n == 1 || n == 2)) * kPoints + v + (n >= 2));
  if (!points[at[0]].hit()) return;
  std::array<std::uint16_t, 4> corner;
  for (std::size_t n = 0; n < 4; ++n) {
    int& number = numbers[at[n]];
    if (number < 0) number = maker.add(points[at[n]].vertex);
    corner[n] = std::uint16_t(number);
  }
  const auto span = [&](std::size_t a, std::size_t b) {
    return std::abs(points[at[a]].depth - points[at[b]].depth);
  };
  const std::size_t shift = span(0, 2) <= span(1, 3) ? 0 : 1;
  maker.triangle(corner[shift], corner[shift + 1], corner[shift + 2]);
  maker.triangle(corner[shift], corner[shift + 2], corner[(shift + 3) % 4]);
}

}  // namespace

bool joined(const HeightPoint& a, const HeightPoint& b) {
  return a.hit() && b.hit() && std::abs(a.depth - b.depth) <= kApart;
}

bool parted(const HeightPoint& a, const HeightPoint& b) {
  return a.hit() != b.hit() || (a.hit() && std::abs(a.depth - b.depth) > kJump);
}

PieceMaker::PieceMaker(const Clay& field, const RayFrame& frame, TilePlace place, std::int32_t base)
    : sampler_(field), iso_(field.scale.iso), frame_(frame), place_(place) {
  // No block begins here, and no other cloth's piece.
  const int number = 1 + 2 * index(frame.axis()) + (frame.fromAbove() ? 1 : 0);
  piece.origin = frame.key(place.u * kSide, place.v * kSide, base);
  std::int32_t& along = piece.origin[frame.axis()];
  along = (along & ~63) + number;
}

RayLine PieceMaker::line(FinePlace place) {
  constexpr int side = kSide * kFine;
  return {sampler_, frame_, {place_.u * side + place[0], place_.v * side + place[1]}};
}

HeightPoint PieceMaker::point(FinePlace place, std::int32_t near, LineVertex found) const {
  HeightPoint point{found.vertex, double(near) - double(found.back), near};
  const double along = frame_.fromAbove() ? -1 - point.depth : point.depth;
  auto& position = point.vertex.position;
  position[std::size_t(index(frame_.u()))] = float(place[0]) / kFine;
  position[std::size_t(index(frame_.v()))] = float(place[1]) / kFine;
  position[std::size_t(index(frame_.axis()))] = float(along - piece.origin[frame_.axis()]);
  return point;
}

HeightPoint PieceMaker::cast(FinePlace place, std::int32_t first, std::int32_t last) {
  ++extraRays;
  const RayLine ray = line(place);
  std::int32_t near = first;
  while (near <= last && ray.at(near) < iso_) ++near;
  return near <= last ? passing(place, near) : HeightPoint{};
}

HeightPoint PieceMaker::passing(FinePlace place, std::int32_t depth) {
  CrossingEdges& edges = edgeScratch();
  line(place).gather(depth, edges, 0);
  const float a = edges.valueA[0], b = edges.valueB[0];
  float level = iso_;
  if ((a >= iso_) == (b >= iso_)) {  // no crossing: halfway between, whatever the slope
    edges.valueB[0] = a == b ? a + 1e-3f : b;
    level = a + (edges.valueB[0] - a) / 2;
  }
  finishVertices(edges, 1, level);
  return point(place, depth, lineVertex(edges, 0, frame_));
}

bool PieceMaker::inside(FinePlace place, std::int32_t depth) {
  return line(place).at(depth) >= iso_;
}

std::uint16_t PieceMaker::add(const PatchVertex& vertex) {
  piece.vertices.push_back(vertex);
  return std::uint16_t(piece.vertices.size() - 1);
}

void PieceMaker::triangle(std::uint16_t a, std::uint16_t b, std::uint16_t c) {
  if (!frame_.fromAbove()) std::swap(b, c);
  piece.indices.insert(piece.indices.end(), {a, b, c});
}

std::int64_t makeRayVertices(const Clay& field, const RayFrame& frame, TilePlace place,
                             RayTile& tile) {
  FieldSampler<8> sampler(field);
  CrossingEdges& edges = edgeScratch();
  std::array<std::size_t, RayTile::kRays> rays;
  int count = 0;
  for (std::uint64_t left = std::exchange(tile.moved, 0); left != 0; left &= left - 1) {
    const int ray = std::countr_zero(left);
    const auto n = std::size_t(ray);
    if (tile.near[n] == kNoDepth) continue;
    const FinePlace at{(place.u * kSide + ray / kSide) * kFine,
                       (place.v * kSide + ray % kSide) * kFine};
    RayLine(sampler, frame, at).gather(tile.near[n], edges, count);
    rays[std::size_t(count++)] = n;
  }
  finishVertices(edges, count, field.scale.iso);
  for (int n = 0; n < count; ++n) {
    const std::size_t ray = rays[std::size_t(n)];
    const LineVertex found = lineVertex(edges, n, frame);
    tile.vertex[ray] = found.vertex;
    tile.back[ray] = found.back;
  }
  return count;
}

PieceMaker meshTile(const Clay& field, const RaySheet& sheet, TilePlace place) {
  PieceMaker maker(field, sheet.frame(), place, sheet.tiles().at(place).base);
  Points points;
  Numbers numbers;
  numbers.fill(-1);
  load(sheet, place, maker, points);
  for (int u = 0; u < kSide; ++u) {
    for (int v = 0; v < kSide; ++v) {
      const auto at = [&](int a, int b) -> const HeightPoint& {
        return points[std::size_t((u + a) * kPoints + v + b)];
      };
      const std::array<HeightPoint, 4> corners{at(0, 0), at(0, 1), at(1, 0), at(1, 1)};
      const bool jumps = parted(corners[0], corners[1]) || parted(corners[0], corners[2]) ||
                         parted(corners[3], corners[1]) || parted(corners[3], corners[2]);
      if (jumps) {
        maker.jumps = true;
        meshFineCell(maker, {u * kFine, v * kFine}, corners);
      } else {
        meshCell(maker, points, numbers, u, v);
      }
    }
  }
  return maker;
}

}  // namespace bozzetto
