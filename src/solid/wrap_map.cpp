#include "bozzetto/solid/wrap_map.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "bozzetto/solid/refine.hpp"
#include "solid/carry.hpp"

namespace bozzetto {

struct WrapMap::Impl {
  double spacing;
  Refined refined;
  CellPieces pieces;
  PieceGrid rest;
  std::vector<CellPiece> posed;

  Impl(const Lattice& control, int levels, double cell)
      : spacing(cell),
        refined(refine(control, levels)),
        pieces(piecesOf(refined.lattice)),
        rest(pieces, pieces.places(inCells(refined.rows, control.points, spacing))) {
    pose(control.points);
  }

  void pose(std::span<const glm::dvec3> control) {
    const auto places = pieces.places(inCells(refined.rows, control, spacing));
    posed.clear();
    for (std::size_t n = 0; n < pieces.pieces.size(); ++n) posed.push_back(pieces.at(n, places));
  }
};

WrapMap::WrapMap(const Lattice& rest, int levels, double spacing)
    : impl_(std::make_unique<Impl>(rest, levels, spacing)) {}
WrapMap::~WrapMap() = default;
WrapMap::WrapMap(WrapMap&&) noexcept = default;
WrapMap& WrapMap::operator=(WrapMap&&) noexcept = default;

// Pieces are listed with the blocks whose corners they may hold: a place between corners of two
// blocks may lie in a piece of either.
WrapPlace WrapMap::find(const glm::dvec3& cell, const WrapPlace& near) const {
  const glm::dvec3 low = glm::floor(glm::floor(cell) / 8.0),
                   high = glm::floor(glm::ceil(cell) / 8.0);
  PieceGrid::Hit hit{near.piece, near.uvw};
  for (int n = 0; n < 8; ++n) {
    const glm::bvec3 upper(n & 1, n >> 1 & 1, n >> 2);
    const glm::dvec3 block = glm::mix(low, high, upper);
    if (n > 0 &&
        glm::any(glm::notEqual(glm::mix(glm::dvec3(0), high - low, upper), glm::dvec3(upper)))) {
      continue;  // the same block again
    }
    const Key key{std::int32_t(block.x), std::int32_t(block.y), std::int32_t(block.z)};
    if (impl_->rest.find(impl_->rest.near(key), cell, hit)) return {hit.piece, hit.uvw};
  }
  return {};
}

void WrapMap::pose(std::span<const glm::dvec3> control) { impl_->pose(control); }

glm::dvec3 WrapMap::carried(const WrapPlace& place) const {
  return impl_->posed[place.piece].at(place.uvw);
}

// Normals go with the inverse transpose of the map's gradient: P⁻ᵀ Rᵀ, both by columns.
glm::dvec3 WrapMap::turned(const WrapPlace& place, const glm::dvec3& normal) const {
  const auto r = impl_->rest.piece(place.piece).derivatives(place.uvw);
  const auto p = impl_->posed[place.piece].derivatives(place.uvw);
  const glm::dvec3 sum = glm::cross(p[1], p[2]) * glm::dot(r[0], normal) +
                         glm::cross(p[2], p[0]) * glm::dot(r[1], normal) +
                         glm::cross(p[0], p[1]) * glm::dot(r[2], normal);
  const double length = glm::length(sum), volume = glm::dot(glm::cross(p[0], p[1]), p[2]);
  if (!(length > 0)) return normal;
  return sum * ((volume < 0 ? -1 : 1) / length);
}

}  // namespace bozzetto
