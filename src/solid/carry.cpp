#include "solid/carry.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "bozzetto/base/error.hpp"
#include "bozzetto/base/parallel.hpp"
#include "bozzetto/grid/key_box.hpp"

namespace bozzetto {
namespace {

using Block = CornerBlock<8>;

constexpr float kDust = 1e-4f;  // densities below this are dropped
constexpr double kSlack = 1e-6;

glm::dvec3 toPlace(Key key) { return {key.i, key.j, key.k}; }

// Blocks that hold corners in [low, high].
KeyBox blocksOver(const glm::dvec3& low, const glm::dvec3& high) {
  KeyBox box;
  for (const Axis axis : kAxes) {
    const int a = index(axis);
    if (!(low[a] > -kWorkspaceRim + 16.0 && high[a] < kWorkspaceRim - 16.0))
      throw Error("wrap: found a lattice that reaches beyond the workspace, expected one inside");
    box.low[axis] = static_cast<std::int32_t>(std::ceil(low[a] - kSlack)) >> 3;
    box.high[axis] = static_cast<std::int32_t>(std::floor(high[a] + kSlack)) >> 3;
  }
  return box;
}

bool isFull(const Block* block) { return block != nullptr && block->interned && block->low >= 1; }

}  // namespace

PieceGrid::PieceGrid(const CellPieces& pieces, std::vector<glm::dvec3> places) {
  constexpr std::size_t kMostPairs = std::size_t{1} << 28;
  std::vector<std::pair<Key, Id>> pairs;
  for (Id n = 0; n < pieces.pieces.size(); ++n) {
    pieces_.push_back(pieces.at(n, places));
    glm::dvec3 low = pieces_[n].corner[0], high = low;
    for (const auto& corner : pieces_[n].corner) {
      low = glm::min(low, corner);
      high = glm::max(high, corner);
    }
    low_.push_back(low);
    high_.push_back(high);
    const KeyBox box = blocksOver(low, high);
    if (box.count() > std::int64_t(kMostPairs) || pairs.size() > kMostPairs)
      throw Error("wrap: found a lattice over more than 2^28 blocks, expected fewer");
    forKeys(box, [&](Key key) { pairs.emplace_back(key, n); });
  }
  std::ranges::sort(pairs);
  std::vector<Id> list;
  for (std::size_t n = 0; n < pairs.size(); ++n) {
    list.push_back(pairs[n].second);
    if (n + 1 < pairs.size() && pairs[n + 1].first == pairs[n].first) continue;
    blocks_.push_back(pairs[n].first);
    near_.add(list);
    list.clear();
  }
}

std::span<const Id> PieceGrid::near(Key block) const {
  const auto place = std::ranges::lower_bound(blocks_, block);
  if (place == blocks_.end() || *place != block) return {};
  return near_[static_cast<std::size_t>(place - blocks_.begin())];
}

std::vector<Key> PieceGrid::blocks() const { return blocks_; }

bool PieceGrid::boxHolds(Id n, const glm::dvec3& place) const {
  const glm::dvec3 &low = low_[n], &high = high_[n];
  return place.x >= low.x - kSlack && place.y >= low.y - kSlack && place.z >= low.z - kSlack &&
         place.x <= high.x + kSlack && place.y <= high.y + kSlack && place.z <= high.z + kSlack;
}

bool PieceGrid::find(std::span<const Id> near, const glm::dvec3& place, Hit& hit) const {
  if (hit.piece != kNoId && boxHolds(hit.piece, place)) {
    if (const auto uvw = piece(hit.piece).inverse(place, hit.uvw)) {
      hit.uvw = *uvw;
      return true;
    }
  }
  for (const Id n : near) {
    if (n == hit.piece || !boxHolds(n, place)) continue;
    if (const auto uvw = piece(n).inverse(place)) {
      hit = {n, *uvw};
      return true;
    }
  }
  return false;
}

std::vector<glm::dvec3> inCells(const WeightRows& rows, std::span<const glm::dvec3> points,
                                double spacing) {
  std::vector<glm::dvec3> result(rows.rowCount());
  rows.apply(points, result);
  for (auto& p : result) {
    p /= spacing;
    if (!std::isfinite(p.x + p.y + p.z))
      throw Error("wrap: found a place that is not finite, expected numbers");
  }
  return result;
}

Carrier::Carrier(const Lattice& refined, std::span<const glm::dvec3> rest,
                 std::span<const glm::dvec3> posed, const Clay& source)
    : source_(source),
      pieces_(piecesOf(refined)),
      rest_(pieces_, pieces_.places(rest)),
      posed_(pieces_, pieces_.places(posed)) {
  const Topology topology(refined);
  rim_.assign(pieces_.pieces.size(), 0);
  for (Id n = 0; n < rim_.size(); ++n) {
    for (const Id point : topology.cellPoints[pieces_.pieces[n].cell])
      rim_[n] |= topology.boundaryPoint[point];
  }
  sources_.resize(pieces_.pieces.size());
  parallelFor(sources_.size(), 256, [&](std::size_t begin, std::size_t end) {
    BlockCache<Block> blocks(source_.tree);
    for (std::size_t n = begin; n < end; ++n) sources_[n] = sourceOf(static_cast<Id>(n), blocks);
  });
}

// Samples inside a piece see corners up to one cell beyond its box.
PieceSource Carrier::sourceOf(Id piece, BlockCache<Block>& blocks) const {
  const KeyBox box = blocksOver(rest_.low(piece) - 1.0, rest_.high(piece) + 1.0);
  PieceSource result;
  bool first = true, mixed = false;
  forKeys(box, [&](Key key) {
    const Block* block = blocks.find(key);
    const PieceSource own{isFull(block) ? PieceSource::Kind::uniform : PieceSource::Kind::empty,
                          isFull(block) ? block->attributes[0] : 0};
    mixed = mixed || (block != nullptr && !isFull(block));
    mixed = mixed || (!first && (own.kind != result.kind || own.attributes != result.attributes));
    result = own;
    first = false;
  });
  if (mixed) result.kind = PieceSource::Kind::mixed;
  return result;
}

std::vector<Key> Carrier::blocks() const {
  std::vector<Key> result;
  BlockCache<Block> old(source_.tree);
  for (const Key key : posed_.blocks()) {
    const auto near = posed_.near(key);
    const bool brings = std::ranges::any_of(
        near, [&](Id n) { return sources_[n].kind != PieceSource::Kind::empty; });
    if (brings || old.find(key) != nullptr) result.push_back(key);
  }
  for (const Key key : rest_.blocks())
    if (old.find(key) != nullptr) result.push_back(key);
  std::ranges::sort(result);
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

// Without a rim piece near, no surface of the lattice passes: one corner speaks for all.
bool Carrier::allInside(const PieceGrid& grid, Key block) const {
  const auto near = grid.near(block);
  if (near.empty() || std::ranges::any_of(near, [&](Id n) { return rim_[n] != 0; })) return false;
  Hit hit;
  return grid.find(near, toPlace(block * 8), hit);
}

const PieceSource* Carrier::commonSource(Key block) const {
  const auto near = posed_.near(block);
  if (near.empty()) return nullptr;
  const PieceSource& first = sources_[near[0]];
  if (first.kind == PieceSource::Kind::mixed) return nullptr;
  const bool same = std::ranges::all_of(near, [&](Id n) {
    return sources_[n].kind == first.kind && sources_[n].attributes == first.attributes;
  });
  return same && allInside(posed_, block) ? &first : nullptr;
}

Ref<Block> Carrier::carried(Key key, FieldSampler<8>& sampler) const {
  if (const PieceSource* common = commonSource(key)) {
    if (common->kind == PieceSource::Kind::empty) return nullptr;
    return Block::uniform(1, common->attributes);
  }
  const Block* old = source_.tree.find(key);
  const auto nearPosed = posed_.near(key), nearRest = rest_.near(key);
  const bool emptied = old != nullptr && allInside(rest_, key);
  Ref<Block> result(new Block());
  Hit posed, rest;
  for (int n = 0; n < 512; ++n) {
    const Key corner = key * 8 + Key{n / 64, n / 8 % 8, n % 8};
    if (posed_.find(nearPosed, toPlace(corner), posed)) {
      carryCorner(n, sampler, posed, *result);
    } else if (old != nullptr && old->value[n] > 0 && !emptied &&
               !rest_.find(nearRest, toPlace(corner), rest)) {
      result->value[n] = old->value[n];
      result->attributes[n] = old->attributes[n];
    }
  }
  return Block::canonical(std::move(result));
}

void Carrier::carryCorner(int n, FieldSampler<8>& sampler, const Hit& hit, Block& out) const {
  const PieceSource& source = sources_[hit.piece];
  if (source.kind == PieceSource::Kind::empty) return;
  if (source.kind == PieceSource::Kind::uniform) {
    out.value[n] = 1;
    out.attributes[n] = source.attributes;
    return;
  }
  const glm::dvec3 from = rest_.piece(hit.piece).at(hit.uvw);
  const CellPoint place = cellPoint({0, 0, 0}, from);
  const float value = sampler.value(place);
  if (value < kDust) return;
  const CellPoint nearest = cellPoint({0, 0, 0}, glm::floor(from + 0.5));
  out.value[n] = value;
  out.attributes[n] =
      packAttributes(sampler.colour(place), holdOf(sampler.attributes(nearest.base)));
}

}  // namespace bozzetto
