// How deep in a tool, or how far from it, corners lie: the argument d of the stamp's curve.
#pragma once
#include "bozzetto/tool/potential.hpp"
#include "bozzetto/tool/stamp.hpp"

namespace bozzetto {

/// What a stamp needs to know beside its curve.
struct StampReach {
  StampProfile profile = StampProfile::radius;
  double iso = 0.5;
  double rim = 0.5;     ///< how far outside the tool d is wanted, in reference radii
  double wall = 0.5;    ///< how far outside a primitive's body fades, likewise
  bool facing = false;  ///< the tool's contact side faces the clay: sculptures have a handle
};

/// The tool of a stamp, as potential.
class StampTool : public Potential {
 public:
  virtual bool hasHandle() const = 0;
  /// Of tools that have one: how much of the tool is there, or from there on towards the clay.
  virtual void evaluateHandle(const LocalFrame& frame, Key first, int side, float* room) const = 0;
};

/// A potential whose values are d: 0 at the core, 1 − iso on the surface, growing outward; beyond
/// the rim anything not below the rim's end. `tool` in cells.
std::unique_ptr<StampTool> makeStampDepth(const ToolShape& tool, const StampReach& reach);

/// A potential whose values are def(d), −1 … height.
std::unique_ptr<StampTool> makeStampPotential(const ToolShape& tool, const StampOptions& options,
                                              double iso, bool facing = false);

/// Of the tool, in cells: of the ball that holds as much as its limit of influence (primitives) or
/// its clay (freeform).
double referenceRadius(const ToolShape& tool);

}  // namespace bozzetto
