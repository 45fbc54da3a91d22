#include "surface/height_rays.hpp"

#include <algorithm>
#include <bit>

#include "bozzetto/base/parallel.hpp"

namespace bozzetto {
namespace {

constexpr int kSide = RayTile::kSide;
constexpr std::array<int, 3> kStrides{64, 8, 1};

// Depths of the corners in blocks `span`.
struct DepthSpan {
  std::int32_t first, last;
  explicit DepthSpan(const BlockSpan& blocks)
      : first(blocks.first * kSide), last(blocks.last * kSide + kSide - 1) {}
};

// The first corner inside of one row of a block, 0 … 7 as the ray meets them; 8 where none is.
int firstInside(const CornerBlock<8>& block, std::size_t start, std::ptrdiff_t stride, float iso) {
  const float* at = block.value.data() + start;
  for (int n = 0; n < kSide; ++n, at += stride)
    if (*at >= iso) return n;
  return kSide;
}

struct BlockRows {
  const CornerBlock<8>* block;
  std::ptrdiff_t strideU, strideV, stride;
  std::size_t start;

  BlockRows(const RayFrame& frame, const CornerBlock<8>* b)
      : block(b),
        strideU(kStrides[std::size_t(index(frame.u()))]),
        strideV(kStrides[std::size_t(index(frame.v()))]),
        stride(kStrides[std::size_t(index(frame.axis()))]),
        start(0) {
    if (!frame.fromAbove()) return;
    start = std::size_t(stride) * (kSide - 1);
    stride = -stride;
  }
  int firstInside(int ray, float iso) const {
    const auto row = start + std::size_t((ray / kSide) * strideU + (ray % kSide) * strideV);
    return bozzetto::firstInside(*block, row, stride, iso);
  }
  bool inside(int ray, int place, float iso) const {
    const auto row = start + std::size_t((ray / kSide) * strideU + (ray % kSide) * strideV);
    return block->value[std::size_t(std::ptrdiff_t(row) + place * stride)] >= iso;
  }
};

enum class Kind { air, clay };

// Blocks `span` are of this kind now.
void mark(std::vector<BlockSpan>& clay, BlockSpan span, Kind kind) {
  std::vector<BlockSpan> now;
  now.reserve(clay.size() + 2);
  for (const BlockSpan& each : clay) {
    if (each.last < span.first || each.first > span.last) {
      now.push_back(each);
      continue;
    }
    if (each.first < span.first) now.push_back({each.first, span.first - 1});
    if (each.last > span.last) now.push_back({span.last + 1, each.last});
  }
  if (kind == Kind::clay) now.push_back(span);
  std::ranges::sort(now, {}, &BlockSpan::first);
  clay.clear();
  for (const BlockSpan& each : now) {
    if (!clay.empty() && clay.back().last + 1 == each.first)
      clay.back().last = each.last;
    else
      clay.push_back(each);
  }
}

bool isClay(const std::vector<BlockSpan>& clay, const BlockSpan& span) {
  return std::ranges::any_of(
      clay, [&](const BlockSpan& s) { return s.first <= span.first && span.last <= s.last; });
}

}  // namespace

Key RayFrame::key(std::int32_t atU, std::int32_t atV, std::int32_t depth) const {
  Key key;
  key[u()] = atU;
  key[v()] = atV;
  key[axis()] = turned(depth);
  return key;
}

bool RayTile::reaches(std::int32_t depth) const {
  return unsettled != 0 || std::ranges::any_of(near, [&](std::int32_t n) { return n >= depth; });
}

void RaySheet::change(Key block, std::int32_t length, const CornerBlock<8>* now, float iso) {
  if (frame_.axis() == Axis::z) {
    const std::int32_t a = frame_.turned(block.k);
    const std::int32_t b = frame_.turned(block.k + length - 1);
    changeSpan({block[frame_.u()], block[frame_.v()]}, {std::min(a, b), std::max(a, b)}, now, iso);
    return;
  }
  for (std::int32_t n = 0; n < length; ++n, ++block.k) {
    const std::int32_t at = frame_.turned(block[frame_.axis()]);
    changeSpan({block[frame_.u()], block[frame_.v()]}, {at, at}, now, iso);
  }
}

void RaySheet::changeSpan(TilePlace place, BlockSpan span, const CornerBlock<8>* now, float iso) {
  const bool clay = now != nullptr && now->high >= iso;
  auto found = tiles_.find(place);
  if (found == tiles_.end()) {
    if (!clay) return touchAround(place, span);
    found = tiles_.try_emplace(place).first;
  }
  RayTile& tile = found->second;
  if (isClay(tile.clay, span) != clay || span.first != span.last) {
    mark(tile.clay, span, clay ? Kind::clay : Kind::air);
  }
  narrow(tile, span, clay ? now : nullptr, iso);
  touchAround(place, span);
}

// The events of §4.3, for all rays through blocks of one content.
void RaySheet::narrow(RayTile& tile, const BlockSpan& span, const CornerBlock<8>* now, float iso) {
  const DepthSpan depths(span);
  const BlockRows rows(frame_, now);
  for (int ray = 0; ray < RayTile::kRays; ++ray) {
    std::int32_t& near = tile.near[std::size_t(ray)];
    std::int32_t& far = tile.far[std::size_t(ray)];
    if (depths.first > far) continue;  // hidden
    const std::int32_t nearWas = near, farWas = far;
    const int place = now == nullptr ? kSide : rows.firstInside(ray, iso);
    const std::int32_t first = place == kSide ? kNoDepth : depths.first + place;
    // The corner at `far` fell below iso: it may be anywhere beyond.
    if (far != kNoDepth && far <= depths.last) {
      const bool stays = now != nullptr && rows.inside(ray, (far - depths.first) % kSide, iso);
      if (!stays) far = kNoDepth;
    }
    if (first < near) {
      near = far = first;
    } else if (first < far) {
      far = first;
    }
    if (near == nearWas && far == farWas) continue;
    const std::uint64_t bit = std::uint64_t{1} << ray;
    tile.moved |= bit;
    tile.stale = true;
    tile.unsettled = near == far ? tile.unsettled & ~bit : tile.unsettled | bit;
  }
}

// Vertices and triangles hang on corners round them, also in the neighbours' rays.
void RaySheet::touchAround(TilePlace place, const BlockSpan& span) {
  constexpr int kReach = 2;  // corners
  const DepthSpan depths(span);
  const std::int32_t low = depths.first - kReach, high = depths.last + kReach;
  for (int n = 0; n < 9; ++n) {
    const std::int32_t du = n / 3 - 1, dv = n % 3 - 1;
    const auto found = tiles_.find({place.u + du, place.v + dv});
    if (found == tiles_.end()) continue;
    RayTile& tile = found->second;
    if (!tile.reaches(tile.jumps ? low - kWall - kBeyond : low)) continue;
    tile.stale = true;
    for (int ray = 0; ray < RayTile::kRays; ++ray) {
      const int u = ray / kSide + du * kSide, v = ray % kSide + dv * kSide;
      if (u < -1 || u > kSide || v < -1 || v > kSide) continue;
      const std::int32_t near = tile.near[std::size_t(ray)];
      if (low <= near && near <= high) tile.moved |= std::uint64_t{1} << ray;
    }
  }
}

// Walks the tile's blocks from the eye; every ray ends at its first corner inside.
std::int64_t RaySheet::cast(const Clay& field, const RayFrame& frame, TilePlace place,
                            RayTile& tile) {
  const std::int64_t count = std::popcount(tile.unsettled);
  std::int32_t least = kNoDepth;
  for (std::uint64_t left = tile.unsettled; left != 0; left &= left - 1) {
    least = std::min(least, tile.near[std::size_t(std::countr_zero(left))]);
  }
  for (const BlockSpan& span : tile.clay) {
    for (std::int32_t b = span.first; b <= span.last && tile.unsettled != 0; ++b) {
      const DepthSpan depths(BlockSpan{b, b});
      if (depths.last < least) continue;
      const Key corner = frame.key(place.u * kSide, place.v * kSide, depths.first);
      const CornerBlock<8>* block = field.tree.find(Clay::Geometry::blockOf(corner));
      if (block == nullptr) continue;
      const BlockRows rows(frame, block);
      for (std::uint64_t left = tile.unsettled; left != 0; left &= left - 1) {
        const int ray = std::countr_zero(left);
        const int first = rows.firstInside(ray, field.scale.iso);
        if (first == kSide) continue;
        tile.near[std::size_t(ray)] = tile.far[std::size_t(ray)] = depths.first + first;
        tile.unsettled &= ~(std::uint64_t{1} << ray);
      }
    }
  }
  for (std::uint64_t left = std::exchange(tile.unsettled, 0); left != 0; left &= left - 1) {
    const auto ray = std::size_t(std::countr_zero(left));
    tile.near[ray] = tile.far[ray] = kNoDepth;
  }
  return count;
}

std::int64_t RaySheet::settle(const Clay& field) {
  std::vector<std::pair<TilePlace, RayTile*>> waiting;
  for (auto& [place, tile] : tiles_)
    if (tile.unsettled != 0) waiting.emplace_back(place, &tile);
  std::vector<std::int64_t> counts(waiting.size());
  parallelFor(waiting.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
      counts[n] = cast(field, frame_, waiting[n].first, *waiting[n].second);
  });
  std::int64_t sum = 0;
  for (const std::int64_t count : counts) sum += count;
  return sum;
}

}  // namespace bozzetto
