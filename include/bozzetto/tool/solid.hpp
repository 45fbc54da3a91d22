// A body as fill and pushed clay see it: the values of a block of corners, and how far the surface
// is.
#pragma once
#include <memory>

#include "bozzetto/tool/potential.hpp"
#include "bozzetto/tool/sculpture.hpp"

namespace bozzetto {

class Solid {
 public:
  virtual ~Solid() = default;
  /// clamp(½ − distance/2) of the side³ corners from `first`, counted from the frame's cell.
  virtual void evaluate(Key first, int side, float* value) const = 0;
  /// Signed distance in cells, negative inside, of a position in cells from the frame's cell.
  virtual double distance(const glm::dvec3& position) const = 0;

  Key cell;  ///< nearest to the centre
};

/// `pose.radii` in cells are the surface.
std::unique_ptr<Solid> makeSolid(Shape shape, const DabPose& pose);

/// A sculpture, the centre of its box at the pose, half its box of influence `pose.radii`. Its
/// distances are made when nobody did before.
std::unique_ptr<Solid> makeSolid(std::shared_ptr<const Sculpture> sculpture, const DabPose& pose);

/// How deep, in cells, the core of a sculpture begins at this pose: no deeper than it is anywhere,
/// and three times its mean depth at most, so that thin arms beside a thick middle count too. Of a
/// ball the outer three quarters of the radius, of a plate half its thickness.
double coreDepth(const Sculpture& sculpture, const DabPose& pose);

}  // namespace bozzetto
