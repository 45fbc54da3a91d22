// How the dabs of a stroke stand: turned to the surface and the stroke, scattered, rolled, repeated
// and snapped.
#pragma once
#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>

namespace bozzetto {

struct Jitter {
  double position = 0;     ///< across the contact direction, × the tool's smallest radius
  double size = 0;         ///< 0…1: dabs are up to so much smaller
  double rotation = 0;     ///< degrees either way about the contact direction
  std::uint64_t seed = 1;  ///< the same seed gives the same dabs

  friend bool operator==(const Jitter&, const Jitter&) = default;
};

struct Placement {
  bool toNormal = false;     ///< the tool's contact direction faces the clay as it was before
  bool alongStroke = false;  ///< the tool's y points where the stroke goes
  double roll = 0;           ///< turns about the axis across the stroke: 1 rolls without sliding
  Jitter jitter;
  double grid = 0;                     ///< positions snap to its multiples, world units; 0: none
  std::array<int, 3> copies{1, 1, 1};  ///< along x, y, z
  glm::dvec3 copyStep{0};              ///< between copies, world units
  bool anchored = false;  ///< one dab at the first point; the last gives its size and direction

  bool plain() const { return *this == Placement{}; }
  friend bool operator==(const Placement&, const Placement&) = default;
};

/// How a tool is turned whose side `contact` (in its own frame) faces away from `outward` and whose
/// y, or z where it touches with that, points towards `heading` as far as that goes. Directions of
/// length 1, `heading` of any; nothing where it runs along `outward`.
std::optional<glm::dmat3> orientationAlong(const glm::dvec3& contact, const glm::dvec3& outward,
                                           const glm::dvec3& heading);

/// Throws Error for numbers that are not finite or out of range, for more than 4096 copies and for
/// copies in one place.
void requireValid(const Placement& placement);

}  // namespace bozzetto
