#include "bozzetto/surface/height_field.hpp"

#include <algorithm>
#include <set>

#include "bozzetto/base/parallel.hpp"
#include "surface/height_mesh.hpp"

namespace bozzetto {

class HeightField::Sheet {
 public:
  explicit Sheet(Facing facing) : rays_(facing) {}

  void change(const Clay& field, const KeyRun& run);
  void finish(const Clay& field, HeightReport& report);

 private:
  struct Work {
    TilePlace place;
    RayTile* tile;
  };
  std::vector<Work> movedTiles();
  std::vector<Work> staleTiles();
  void choose(RayTile& tile) const;

  RaySheet rays_;
};

// All pieces of the tree inside the run, and the holes between them.
void HeightField::Sheet::change(const Clay& field, const KeyRun& run) {
  forPieces(field.tree, run, [&](KeyRun piece, const Ref<CornerBlock<8>>& block) {
    rays_.change(piece.key, piece.length, block.get(), field.scale.iso);
  });
}

std::vector<HeightField::Sheet::Work> HeightField::Sheet::movedTiles() {
  std::vector<Work> found;
  for (auto& [place, tile] : rays_.tiles())
    if (tile.moved != 0) found.push_back({place, &tile});
  return found;
}

// A tile's triangles reach to the first rays of the tiles above it.
std::vector<HeightField::Sheet::Work> HeightField::Sheet::staleTiles() {
  std::vector<Work> found;
  auto& tiles = rays_.tiles();
  for (auto& [place, tile] : tiles) {
    bool stale = tile.stale;
    for (int n = 1; n < 4 && !stale; ++n) {
      const auto above = tiles.find({place.u + n / 2, place.v + n % 2});
      stale = above != tiles.end() && above->second.stale;
    }
    if (stale) found.push_back({place, &tile});
  }
  return found;
}

// The piece is named when it is first shown.
void HeightField::Sheet::choose(RayTile& tile) const {
  if (tile.shown) return;
  const auto nearest = std::ranges::min(tile.near);
  if (nearest == kNoDepth) return;
  tile.base = nearest;
  tile.shown = true;
}

void HeightField::Sheet::finish(const Clay& field, HeightReport& report) {
  report.rays += rays_.settle(field);
  const std::vector<Work> moved = movedTiles(), stale = staleTiles();
  std::vector<std::int64_t> counts(moved.size());
  parallelFor(moved.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
      counts[n] = makeRayVertices(field, rays_.frame(), moved[n].place, *moved[n].tile);
  });
  for (const std::int64_t count : counts) report.vertices += count;
  for (const Work& work : stale) choose(*work.tile);
  struct Made {
    HeightPiece piece;
    std::int64_t extraRays = 0;
  };
  std::vector<Made> made(stale.size());
  parallelFor(stale.size(), 2, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      PieceMaker maker = meshTile(field, rays_, stale[n].place);
      made[n] = {std::move(maker.piece), maker.extraRays};
      stale[n].tile->jumps = maker.jumps;
    }
  });
  for (std::size_t n = 0; n < stale.size(); ++n) {
    stale[n].tile->stale = false;
    report.extraRays += made[n].extraRays;
    if (stale[n].tile->shown) report.pieces.push_back(std::move(made[n].piece));
  }
}

HeightField::HeightField(std::vector<Facing> facings) : facings_(std::move(facings)) {}
HeightField::~HeightField() = default;
HeightField::HeightField(HeightField&&) noexcept = default;
HeightField& HeightField::operator=(HeightField&&) noexcept = default;

HeightReport HeightField::rebuild(const Clay& field) {
  sheets_.clear();
  for (const Facing& facing : facings_) sheets_.push_back(std::make_unique<Sheet>(facing));
  HeightReport report;
  for (const auto& sheet : sheets_) {
    for (const auto& [key, run] : field.tree) sheet->change(field, {key, run.length});
    sheet->finish(field, report);
  }
  return report;
}

HeightReport HeightField::refresh(const Clay& field, std::span<const KeyRun> changed) {
  HeightReport report;
  for (const auto& sheet : sheets_) {
    for (const KeyRun& run : changed) sheet->change(field, run);
    sheet->finish(field, report);
  }
  return report;
}

}  // namespace bozzetto
