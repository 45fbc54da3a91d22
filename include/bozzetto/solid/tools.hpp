// The sculpting tools of McDonnell & Qin (§6): each takes a solid and gives another. Throws Error
// when what is asked for cannot be done. Mass, hardness and rest shape stay where the solid does.
#pragma once
#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "bozzetto/solid/pick.hpp"
#include "bozzetto/solid/simulation.hpp"

namespace bozzetto {

// Geometric and topological tools (§6.3).

/// Without that control cell; not the last one.
Solid carved(const Solid& solid, Id cell);

/// With a cell grown from a boundary face along its normal, by `length`, or, where that is 0, by
/// the size of the cell behind it.
Solid extruded(const Solid& solid, Id face, double length);

/// With a cell between two boundary faces of equally many points, for loops and handles. Faces may
/// share an edge. `warning` is told where cells would share two faces.
Solid joined(const Solid& solid, Id faceA, Id faceB, std::string* warning = nullptr);

/// The cell split as subdivision would, in its present shape; neighbours get its new points.
Solid subdivided(const Solid& solid, Id cell);

enum class Sharp : std::uint8_t { no, yes };
/// Tags a point, an edge, or all edges of a face.
Solid sharpened(const Solid& solid, Element element, Id n, Sharp sharp);

// Deformation tools (§6.4).

enum class Matter : std::uint8_t { mass, hardness };
/// A round brush: mass or stiffness times `factor` at its middle, once at its rim; in [1e-3, 1e3].
Solid painted(const Solid& solid, Matter matter, const glm::dvec3& at, double radius,
              double factor);

/// Rest lengths times 1 + amount at the middle of a round brush; negative: deflate.
Solid inflated(const Solid& solid, const glm::dvec3& at, double radius, double amount);

enum class TakesPart : std::uint8_t { no, yes };
/// Refined cells within the radius take part in the physics, or no longer.
Solid trimmed(const Solid& solid, const glm::dvec3& at, double radius, TakesPart part);

/// Only control points inside the box move; all when there is none.
Solid windowed(const Solid& solid, const std::optional<std::array<glm::dvec3, 2>>& box);

/// The present shape is the rest shape, and still.
Solid atRest(const Solid& solid);

/// A pull of the nearest refined point to a place.
struct Pull {
  glm::dvec3 at, to;
};
struct RunReport {
  int steps = 0;
  int rolledBack = 0;     ///< steps that were taken back
  double iterations = 0;  ///< mean
  double energy = 0;      ///< at the end
  double msStep = 0;      ///< mean, by the clock
};
/// `steps` steps of physics with these ropes.
Solid pulled(const Solid& solid, std::span<const Pull> pulls, double strength, int steps,
             RunReport* report = nullptr);

/// The cubic B-spline through places, uniform, with natural ends: control points.
std::vector<glm::dvec3> splineThrough(std::span<const glm::dvec3> places);
/// The places it passes at whole parameters.
std::vector<glm::dvec3> splinePlaces(std::span<const glm::dvec3> controls);
/// The curve itself, `cuts` ≥ 1 pieces between two such places, both ends included.
std::vector<glm::dvec3> splineCurve(std::span<const glm::dvec3> controls, int cuts);

struct SplineDrag {
  std::size_t control;
  glm::dvec3 by;
};
/// A curve through the refined points nearest to `points`, its control points dragged, pulls them.
Solid splined(const Solid& solid, std::span<const glm::dvec3> points,
              std::span<const SplineDrag> drags, int steps, RunReport* report = nullptr);

// What can be felt and seen.

/// Mean stiffness of the springs within the radius, 0 where there are none (§6.2).
double probedStiffness(const Solid& solid, const glm::dvec3& at, double radius);

enum class Tint : std::uint8_t { mass, hardness, strain };
/// A number for each refined point, for colour maps. Strain: mean |l − L|/L of its springs.
std::vector<double> tinted(const Solid& solid, Tint tint);

/// A coarse solid of cubical cells where the clay is: `cells` along the longest side of `box`; a
/// cell stays where `filled(middle)` says so.
NamedLattice coarseBlock(const std::array<glm::dvec3, 2>& box, int cells,
                         const std::function<bool(const glm::dvec3&)>& filled);

}  // namespace bozzetto
