// The physical life of a solid (McDonnell & Qin §5): control points move so that the refined mass
// points obey springs, ropes and damping.
#pragma once
#include <memory>
#include <span>

#include "bozzetto/solid/physics.hpp"
#include "bozzetto/solid/solid.hpp"

namespace bozzetto {

class Simulation {
 public:
  /// Throws Error for settings out of range. The rest shape is the solid's matter's, or the present
  /// shape where that says nothing.
  explicit Simulation(const Solid& solid);
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// One step of settings.timeStep. A step that would explode or turn cells inside out is taken
  /// back, leaves the solid at rest, and says so.
  StepReport step(std::span<const Rope> ropes = {});

  /// The solid as it is now, matter with it.
  Solid solid() const;

  const Lattice& refined() const;              ///< topology; places as of the start
  std::span<const glm::dvec3> points() const;  ///< refined points now
  double energy() const;
  std::size_t invertedCells() const;
  /// Forces of springs and ropes on control points.
  std::vector<glm::dvec3> controlForces(std::span<const Rope> ropes = {}) const;
  /// Greatest stable step of the live solver (its own sub-steps are 0.9 of it).
  double stableStep() const;
  /// How far a refined point gives to a force of 1 within one step: aᵀ S⁻¹ a. 1/this is the
  /// stiffness a hand feels. Needs the standard solver or paperExplicit (there: 1/mass).
  double compliance(Id point) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace bozzetto
