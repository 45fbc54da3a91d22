// Where and how each dab of a stroke stands (see placement.hpp).
#pragma once
#include <optional>
#include <vector>

#include "bozzetto/field/sampler.hpp"
#include "bozzetto/tool/stroke.hpp"
#include "tool/repeats.hpp"

namespace bozzetto {

/// Position in cells from the stroke's origin.
struct Stance {
  glm::dvec3 position;
  glm::dmat3 orientation;
};

/// One dab before symmetry; position in cells from the stroke's origin.
struct Standing {
  glm::dvec3 position;
  glm::dmat3 orientation;
  double factor = 1;     ///< of its size
  bool skipped = false;  ///< stands where the one before stood, on the grid of positions
  /// Of every copy and, of each, every image, before the image is taken. Empty: all as the first.
  std::vector<Stance> each{};
};

template <int Side>
class Placer {
 public:
  /// `tool` in cells. Keeps a duplicate of the field where the surface's normal is wanted; radial
  /// images face it where they stand, mirrored ones as what they mirror.
  Placer(const Placement& placement, const ToolShape& tool, const Field<Side>& field,
         const Repeats& repeats);

  Standing at(const StrokePath& path, std::int64_t n) const;
  /// Of the copies, in cells; the first is 0.
  const std::vector<glm::dvec3>& copies() const { return copies_; }
  bool facing() const { return placement_.toNormal; }
  std::int64_t countOf(std::int64_t dabs) const { return placement_.anchored ? 1 : dabs; }
  /// How many of the first dabs stay as they are however the stroke goes on.
  std::int64_t sureOf(std::int64_t dabs) const;
  /// What is made otherwise than asked for; empty when nothing is.
  std::string notice(const StrokePath& path) const;

 private:
  // What is known of one before it is turned.
  struct Dab {
    std::int64_t n;
    glm::dvec3 position, heading;
    double along;  // the stroke, cells
    std::optional<glm::dvec3> normal;
  };

  glm::dvec3 heading(const StrokePath& path, std::int64_t n) const;
  std::optional<glm::dvec3> normalAt(const glm::dvec3& position) const;
  Stance stance(const Dab& dab, const std::optional<glm::dvec3>& normal) const;
  std::vector<Stance> stances(const Dab& dab, const Stance& first) const;
  glm::dmat3 turned(const std::optional<glm::dvec3>& normal, const glm::dvec3& heading) const;
  double grown(const glm::dvec3& way) const;  // by the gesture, × its own size
  void roll(const Dab& dab, Stance& stance) const;
  void scatter(std::int64_t n, Stance& stance) const;
  glm::dvec3 snapped(const glm::dvec3& position) const;

  Placement placement_;
  glm::dmat3 base_;     // the tool's rotation as chosen
  glm::dvec3 contact_;  // in the tool's frame
  glm::dvec3 radii_;    // cells
  Repeats repeats_;
  double spacing_;
  Field<Side> before_;
  std::vector<glm::dvec3> copies_;
};

extern template class Placer<1>;
extern template class Placer<8>;

}  // namespace bozzetto
