// The internal forces of a solid on its refined points (McDonnell & Qin §4, solid.md §2): normal
// springs along edges, angular springs at the corners of faces. Both are gradients of energies, so
// that momentum and angular momentum are kept.
#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "bozzetto/solid/lattice.hpp"

namespace bozzetto {

/// Energy of a corner with angle θ: ½κ(θ−θ⁰)², or ½κ'(cosθ−cosθ⁰)², equal to first order, cheaper,
/// and evaluated side by side.
enum class AngularLaw : std::uint8_t { angle, cosine };

struct NormalSpring {
  Id a, b;
  double stiffness, length;
};

/// The four corners of a quad; stiffness is κ, 0 for none.
struct QuadSprings {
  std::array<Id, 4> points;
  std::array<double, 4> stiffness, angle;
};

using Places = std::span<const glm::dvec3>;
using MutablePlaces = std::span<glm::dvec3>;

/// cosθ and ∂cosθ/∂ of the arms, or the like of θ.
struct CornerGradient {
  double value;
  glm::dvec3 first, second;
};
/// Angle between two arms; zero gradients where they are parallel.
CornerGradient angleBetween(const glm::dvec3& first, const glm::dvec3& second);

class Springs {
 public:
  Springs(std::vector<NormalSpring> normal, std::vector<QuadSprings> quads, AngularLaw law);

  double normalEnergy(Places d) const;
  double angularEnergy(Places d) const;
  double energy(Places d) const { return normalEnergy(d) + angularEnergy(d); }
  /// Adds the internal forces.
  void addForces(Places d, MutablePlaces force) const;

  /// Takes the Gauss-Newton tangent at d: positive semi-definite (solid.md §2, 3).
  void linearise(Places d);
  /// Adds tangent · x.
  void addTangent(Places x, MutablePlaces y) const;

  /// Rest lengths and angles go this part of their way to what they are at d (clay).
  void creep(Places d, double part);

  const std::vector<NormalSpring>& normal() const { return normal_; }
  const std::vector<QuadSprings>& quads() const { return quads_; }
  AngularLaw law() const { return law_; }

  static constexpr int kLanes = 8;
  /// Eight quads side by side.
  struct Batch {
    std::array<std::array<Id, kLanes>, 4> points;
    std::array<std::array<double, kLanes>, 4> stiffness, cosine;
  };
  /// ∂cosθ/∂ of both arms at four corners of eight quads, times √stiffness.
  struct BatchTangent {
    std::array<std::array<std::array<double, kLanes>, 6>, 4> gradient;
  };

 private:
  struct NormalTangent {
    glm::dvec3 direction;
    double along, across;
  };

  void addNormalForces(Places d, MutablePlaces force) const;
  void addAngleForces(Places d, MutablePlaces force) const;

  std::vector<NormalSpring> normal_;
  std::vector<QuadSprings> quads_;
  AngularLaw law_;
  std::vector<Batch> batches_;
  std::vector<NormalTangent> normalTangent_;
  std::vector<BatchTangent> batchTangent_;
};

/// κ of a corner whose arms have these rest lengths: k_a keeps its meaning at small angles.
inline double cornerStiffness(double angular, double first, double second) {
  return 0.5 * angular * first * second;
}

}  // namespace bozzetto
