// The clay as cloths thrown over it along grid axes (Dewaele & Cani 2003, §4.2 and §4.3): what can
// be seen of it from one side, made from one ray a row of corners instead of all its cubes. Used
// while so much of the clay moves that meshing it would take too long.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "bozzetto/field/field.hpp"
#include "bozzetto/surface/patch.hpp"

namespace bozzetto {

/// From which end of which axis rays come.
struct Facing {
  enum class From : unsigned char { above, below };
  Axis axis = Axis::z;
  From from = From::above;  ///< of the axis: the end where its coordinate is greatest
  friend auto operator<=>(const Facing&, const Facing&) = default;
};

/// Triangles of 8 × 8 rays of a cloth. Vertices of whole rays are those that the meshed surface has
/// on the same edges, bit for bit.
struct HeightPiece {
  Key origin;  ///< names the piece; positions count from here; no block of the field has it
  std::vector<PatchVertex> vertices;
  std::vector<std::uint16_t> indices;  ///< counter-clockwise from outside; none: the piece is gone
};

/// What one refresh did.
struct HeightReport {
  std::int64_t rays = 0;            ///< cast between what is known to be their near and far ends
  std::int64_t extraRays = 0;       ///< between others, where depth jumps
  std::int64_t vertices = 0;        ///< of whole rays made anew
  std::vector<HeightPiece> pieces;  ///< made, altered or gone, in a fixed order
};

/// Follows a field as a Surface does. The same for any number of threads.
class HeightField {
 public:
  /// One cloth for each.
  explicit HeightField(std::vector<Facing> facings);
  ~HeightField();
  HeightField(HeightField&&) noexcept;
  HeightField& operator=(HeightField&&) noexcept;

  const std::vector<Facing>& facings() const { return facings_; }

  /// Everything anew. O(blocks + rays).
  HeightReport rebuild(const Clay& field);
  /// After corners in these blocks (sorted, not overlapping) changed. O(changed blocks, and the
  /// rays whose surface they hide, show or move).
  HeightReport refresh(const Clay& field, std::span<const KeyRun> changed);

 private:
  class Sheet;
  std::vector<Facing> facings_;
  std::vector<std::unique_ptr<Sheet>> sheets_;
};

}  // namespace bozzetto
