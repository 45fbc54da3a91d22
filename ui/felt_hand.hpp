// The mouse in the haptic loop: a hand that feels a rope or a surface, in world units. The loop
// runs while this lives.
#pragma once
#include "bozzetto/haptic/loop.hpp"
#include "bozzetto/solid/lattice.hpp"

namespace bozzetto::ui {

class FeltHand {
 public:
  /// Begins at a place; `metres` of a world unit in the device's room.
  FeltHand(const glm::dvec3& at, double metres);

  /// Where the pointer is.
  void place(const glm::dvec3& at);
  /// A rope to this point of the clay, newtons a metre.
  void feelRope(const glm::dvec3& grabbed, double stiffness);
  /// The faces of a surface, newtons a metre.
  void feelSurface(const Lattice& surface, double stiffness);

  glm::dvec3 force() const { return device_.force(); }  ///< newtons
  /// Where the tool is: it gives way to the force and stays behind the pointer.
  glm::dvec3 tool() const;
  static constexpr double kMostForce = 3;  ///< newtons

 private:
  glm::dvec3 inRoom(const glm::dvec3& place) const { return (place - origin_) * metres_; }
  void publish();

  glm::dvec3 origin_, place_;
  double metres_;
  haptic::Scene scene_;
  haptic::MouseDevice device_;
  haptic::Loop loop_;
};

}  // namespace bozzetto::ui
