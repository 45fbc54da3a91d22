// What a solid is made of and how it moves: plain values. Units: mass per refined point 1, normal
// springs 1, so times are in √(m/k); lengths do not matter (solid.md §2).
#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "bozzetto/solid/lists.hpp"

namespace bozzetto {

/// paperExplicit: forward Euler, consistent mass (McDonnell & Qin, Eq. 5). paperImplicit: Eq. 6
/// with plain conjugate gradients. standard: Eq. 6 for the displacement, preconditioned. live:
/// symplectic Euler, lumped mass, as many sub-steps as it takes to be stable.
enum class Solver : std::uint8_t { standard, live, paperExplicit, paperImplicit };

std::string_view toText(Solver solver);

/// The global sliders.
struct SolidSettings {
  Solver solver = Solver::standard;
  int levels = 1;            ///< refinements between control and mass points, 1 … 3
  double timeStep = 0.5;     ///< of one step
  double damping = 1;        ///< γ, 1/time
  double stiffness = 1;      ///< of normal springs
  double angular = 0.5;      ///< of angular springs, against normal ones
  double ropeStrength = 10;  ///< stiffness of ropes
  double creep = 0;          ///< 1/time: how fast the rest shape follows, like clay; 0 = elastic

  friend bool operator==(const SolidSettings&, const SolidSettings&) = default;
};

/// Throws Error for settings out of range.
void requireValid(const SolidSettings& settings);

/// What differs from the uniform solid at rest. Empty lists mean: everywhere as usual.
struct SolidMatter {
  std::vector<double> mass, hardness;  ///< a refined point each; 1 as usual
  std::vector<double> lengths;         ///< rest length of each refined edge
  std::vector<double> angles;          ///< rest angle of each corner of each refined face
  std::vector<std::uint8_t> trimmed;   ///< refined cells that take no part
  std::vector<std::uint8_t> fixed;     ///< control points outside the physical window
  std::vector<glm::dvec3> velocity;    ///< of control points

  friend bool operator==(const SolidMatter&, const SolidMatter&) = default;
};

/// A spring of no rest length from a refined point to a place (§6.2).
struct Rope {
  Id point;
  glm::dvec3 to;
  double strength;
};

struct StepReport {
  int iterations = 0;        ///< of conjugate gradients, or sub-steps
  double residual = 0;       ///< relative
  double energy = 0;         ///< of all springs, when asked for
  std::size_t inverted = 0;  ///< refined cells turned inside out
  bool rolledBack = false;   ///< the step would have exploded or inverted cells: nothing moved
};

}  // namespace bozzetto
