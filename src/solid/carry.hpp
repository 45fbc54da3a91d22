// The inside of a posed lattice, block by block: what each corner of the clay becomes.
#pragma once
#include <vector>

#include "bozzetto/field/sampler.hpp"
#include "bozzetto/solid/cells.hpp"
#include "bozzetto/solid/refine.hpp"

namespace bozzetto {

/// Pieces of cells at one pose, in cells of the grid, and which blocks each may reach.
class PieceGrid {
 public:
  PieceGrid(const CellPieces& pieces, std::vector<glm::dvec3> places);

  /// Numbers of the pieces whose box meets the block, rising.
  std::span<const Id> near(Key block) const;
  std::vector<Key> blocks() const;  ///< those with any piece near, in order
  bool boxHolds(Id piece, const glm::dvec3& place) const;
  const CellPiece& piece(Id n) const { return pieces_[n]; }
  struct Hit {
    Id piece = kNoId;
    glm::dvec3 uvw{0.5};
  };
  /// The piece of `near` that holds the place; the one found last is asked first, for neighbouring
  /// places mostly share it. False where there is none.
  bool find(std::span<const Id> near, const glm::dvec3& place, Hit& hit) const;
  const glm::dvec3& low(Id n) const { return low_[n]; }
  const glm::dvec3& high(Id n) const { return high_[n]; }

 private:
  std::vector<CellPiece> pieces_;
  std::vector<glm::dvec3> low_, high_;
  std::vector<Key> blocks_;
  Lists near_;  // one list a block
};

/// Refined points in cells of the grid. Throws Error for places that are not finite.
std::vector<glm::dvec3> inCells(const WeightRows& rows, std::span<const glm::dvec3> points,
                                double spacing);

/// What the clay in the rest box of a piece is.
struct PieceSource {
  enum class Kind : std::uint8_t { empty, uniform, mixed } kind = Kind::empty;
  Attributes attributes = 0;  ///< of uniform full clay
};

/// Carries clay from a lattice at rest to the same lattice posed.
class Carrier {
 public:
  Carrier(const Lattice& refined, std::span<const glm::dvec3> rest,
          std::span<const glm::dvec3> posed, const Clay& source);

  /// Blocks that may change, in order.
  std::vector<Key> blocks() const;

  /// What the block becomes; null when empty. From several threads, each with its own sampler.
  Ref<CornerBlock<8>> carried(Key block, FieldSampler<8>& sampler) const;

 private:
  using Hit = PieceGrid::Hit;
  PieceSource sourceOf(Id piece, BlockCache<CornerBlock<8>>& blocks) const;
  bool allInside(const PieceGrid& grid, Key block) const;
  const PieceSource* commonSource(Key block) const;
  void carryCorner(int n, FieldSampler<8>& sampler, const Hit& hit, CornerBlock<8>& out) const;

  const Clay& source_;
  CellPieces pieces_;
  PieceGrid rest_, posed_;
  std::vector<PieceSource> sources_;
  std::vector<std::uint8_t> rim_;  // pieces at the boundary of the lattice
};

}  // namespace bozzetto
