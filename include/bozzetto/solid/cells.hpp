// Refined cells as maps: where a place in a cell lies when the solid is posed otherwise
// (solid.md §3).
#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "bozzetto/solid/lattice.hpp"

namespace bozzetto {

enum class PieceKind : std::uint8_t { hexahedron, tetrahedron };

/// A cell or part of one, with coordinates (u, v, w) inside. Hexahedron: trilinear, corner n at
/// u = bit 0, v = bit 1, w = bit 2 of n. Tetrahedron: corners 0…3, (u, v, w) the weights of 1,
/// 2, 3.
struct CellPiece {
  PieceKind kind = PieceKind::hexahedron;
  std::array<glm::dvec3, 8> corner;

  glm::dvec3 at(const glm::dvec3& uvw) const;
  /// (u, v, w) of a place, by Newton's method from `start`; nothing when the place is outside.
  std::optional<glm::dvec3> inverse(const glm::dvec3& place,
                                    const glm::dvec3& start = glm::dvec3(0.5)) const;
  /// Of the place along u, v, w.
  std::array<glm::dvec3, 3> derivatives(const glm::dvec3& uvw) const;
  /// Exact; negative when turned inside out.
  double volume() const;
};

/// Hexahedra are kept whole; cells of other kinds become tetrahedra round their middles.
struct CellPieces {
  struct Piece {
    PieceKind kind;
    std::array<Id, 8> points;  ///< tetrahedra repeat the last
    Id cell;
  };
  std::vector<Piece> pieces;
  /// Points beyond those of the lattice: middles of cells and faces, as means of its points.
  std::vector<std::vector<Id>> middles;

  /// Places of the lattice's points and of the middles.
  std::vector<glm::dvec3> places(std::span<const glm::dvec3> points) const;
  /// Piece n with its points at `places`.
  CellPiece at(std::size_t n, std::span<const glm::dvec3> places) const;
};

/// Right-handed at the lattice's places. O(n).
CellPieces piecesOf(const Lattice& refined);

}  // namespace bozzetto
