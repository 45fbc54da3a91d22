// What the hand holds in solid mode: values that panels show and operations are made of.
#pragma once
#include <optional>
#include <span>
#include <string_view>

#include "ui/solid_shown.hpp"

namespace bozzetto::ui {

/// Whom tools work on.
enum class WorkMode { clay, solid };

enum class SolidTool {
  move,
  rope,
  spline,
  carve,
  extrude,
  join,
  subdivide,
  sharp,
  mass,
  stiffness,
  inflate,
  trim,
  probe
};

/// What pressing and dragging mean. A curve gets points by clicks and is dragged by its controls.
enum class SolidGrip { click, drag, brush, curve, touch };

/// What the tool takes: elements of the control lattice, or the surface as physics has it.
enum class SolidReach { control, surface };

struct SolidToolRow {
  SolidTool tool;
  std::string_view title, verb, inverse;  ///< `inverse` with Ctrl held; empty: none
  std::string_view what;                  ///< one line on the card
  std::string_view tip;
  SolidReach reach;
  Element element;  ///< of the control lattice: what lights up under the pointer
  SolidGrip grip;
};

inline constexpr int kSolidToolCount = 13;
std::span<const SolidToolRow, kSolidToolCount> solidToolTable();
const SolidToolRow& rowOf(SolidTool tool);

struct SolidState {
  SolidTool tool = SolidTool::move;
  Element sharpens = Element::face;
  double radius = 10;  ///< of brushes, world units
  double factor = 2;   ///< of mass and stiffness
  double amount = .5;  ///< of inflation
  int steps = 20;      ///< of physics after a tool
  double length = 0;   ///< of extrusion, world units; 0: as the cell behind

  Key cells{3, 3, 3};  ///< of new blocks and wraps
  double edge = 20;    ///< world units
  int coarse = 6;      ///< cells along the clay
  int bakeLevels = 2;
  bool keepMass = true;

  bool lattice = true, wires = true, surface = true;
  SolidMap map = SolidMap::none;
  std::optional<SolidSettings> settings;  ///< while they are being changed
};

/// What lies under the pointer, and where: an element of the control lattice, or the point of the
/// refined solid that is nearest to where the surface was hit.
struct SolidHit {
  Id element = kNoId;
  glm::dvec3 place{0};
};

/// The curve that is being laid through refined points.
struct SolidCurve {
  std::vector<Id> points;
  std::size_t of = 0;                 ///< how many refined points the solid had
  std::optional<std::size_t> handle;  ///< the control under the pointer, or dragged

  bool isDragged(std::size_t n) const { return handle && *handle == n; }
};

}  // namespace bozzetto::ui
