// Where and how each dab of a stroke stands (see placement.hpp).
#pragma once
#include <optional>
#include <vector>

#include "bozzetto/field/sampler.hpp"
#include "bozzetto/tool/stroke.hpp"

namespace bozzetto {

/// One dab before symmetry; position in cells from the stroke's origin.
struct Standing {
  glm::dvec3 position;
  glm::dmat3 orientation;
  double factor = 1;     ///< of its size
  bool skipped = false;  ///< stands where the one before stood, on the grid of positions
};

template <int Side>
class Placer {
 public:
  /// `tool` in cells. Keeps a duplicate of the field where the surface's normal is wanted.
  Placer(const Placement& placement, const ToolShape& tool, const Field<Side>& field, Key origin);

  Standing at(const StrokePath& path, std::int64_t n) const;
  /// Of the copies, in cells; the first is 0.
  const std::vector<glm::dvec3>& copies() const { return copies_; }
  std::int64_t countOf(std::int64_t dabs) const { return placement_.anchored ? 1 : dabs; }
  /// How many of the first dabs stay as they are however the stroke goes on.
  std::int64_t sureOf(std::int64_t dabs) const;
  /// What is made otherwise than asked for; empty when nothing is.
  std::string notice(const StrokePath& path) const;

 private:
  glm::dvec3 heading(const StrokePath& path, std::int64_t n) const;
  std::optional<glm::dvec3> normalAt(const glm::dvec3& position) const;
  glm::dmat3 turned(const glm::dvec3& position, const glm::dvec3& heading) const;
  double grown(const glm::dvec3& way) const;  // by the gesture, × its own size
  void roll(double along, const glm::dvec3& heading, Standing& standing) const;
  void scatter(std::int64_t n, Standing& standing) const;
  glm::dvec3 snapped(const glm::dvec3& position) const;

  Placement placement_;
  glm::dmat3 base_;     // the tool's rotation as chosen
  glm::dvec3 contact_;  // in the tool's frame
  glm::dvec3 radii_;    // cells
  Key origin_;
  double spacing_;
  Field<Side> before_;
  std::vector<glm::dvec3> copies_;
};

extern template class Placer<1>;
extern template class Placer<8>;

}  // namespace bozzetto
