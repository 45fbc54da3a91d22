// A tool that is a sculpture (Ferley §4.1.2): a duplicate of the trees of some clay, which shares
// its blocks, with what strokes need to know of it.
#pragma once
#include <glm/vec3.hpp>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "bozzetto/field/field.hpp"
#include "bozzetto/tool/lasso.hpp"

namespace bozzetto {

/// What a sculptor may say about a tool. Positions in the world units of the clay it is made of.
struct SculptureOptions {
  std::optional<glm::dvec3> pivot;  ///< lies on the stroke's points; else the centre of its bounds
  glm::dvec3 contact{0, 0, -1};     ///< the side of the tool that meets the clay; its own frame
};

/// Immutable once made; strokes share it by pointer. Coarser copies and distances are made when
/// they are first asked for, by any thread.
class Sculpture {
 public:
  /// Duplicates the tree: pointers only. Throws Error for clay without corners, for a pivot or
  /// contact that is not finite, and for clay wider than 2¹⁵ cells. O(nodes).
  explicit Sculpture(Clay clay, const SculptureOptions& options = {});
  ~Sculpture();

  const Clay& clay() const { return clay_; }
  /// The clay (level 0), or pre-filtered for cells 2ⁿ times as large, n ≤ 8; as its potential reads
  /// it. Throws what resample throws.
  const struct SculptureLevel& level(int n) const;
  static constexpr int kLevels = 8;

  const FieldScale& scale() const { return clay_.scale; }
  /// Of the corners with clay.
  const KeyBox& bounds() const { return bounds_; }
  /// Middle of the bounds, in cells.
  glm::dvec3 centre() const;
  /// Half the box of influence, in cells: trilinear reconstruction reaches one beyond the bounds.
  glm::dvec3 halfExtents() const;
  /// In cells from the centre.
  const glm::dvec3& pivot() const { return pivot_; }
  const glm::dvec3& contact() const { return contact_; }  ///< length 1
  /// Of the ball whose volume is that of the tool (mass ÷ full), in cells.
  double referenceRadius() const;

  struct Colours {
    bool many = false;  ///< clay of two colours is in it
    Colour mean;
  };
  /// O(corners) when first asked for.
  const Colours& colours() const;
  /// To its surface, for those who push clay with it. Made when first asked for: milliseconds to
  /// half a second; whoever makes a tool for that asks early.
  const class SculptedDistance& distance() const;

 private:
  Clay clay_;
  KeyBox bounds_;
  glm::dvec3 pivot_{0}, contact_{0};
  mutable std::mutex making_;
  mutable std::optional<Colours> colours_;
  mutable std::vector<std::unique_ptr<const SculptureLevel>> levels_;
  mutable std::unique_ptr<const SculptedDistance> distance_;
};

/// The part of the clay inside the box of corners; blocks wholly inside are shared. O(nodes + rim).
Clay partOf(const Clay& clay, const KeyBox& box);
/// Of that, what a lasso holds. O(blocks · outline + corners near it · outline), in parallel.
Clay partOf(const Clay& clay, const KeyBox& box, const Lasso& lasso);

/// The box of corners with clay; empty when there is none. O(nodes + blocks at its faces).
KeyBox boundsOf(const Clay& clay);

}  // namespace bozzetto
