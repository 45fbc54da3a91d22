// What the hand holds and how strokes are made: values the panels show and operations are made of.
#pragma once
#include <array>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "bozzetto/clay/settings.hpp"
#include "bozzetto/sculptor/operation.hpp"
#include "bozzetto/tool/action.hpp"
#include "bozzetto/tool/sculpture.hpp"
#include "bozzetto/tool/shape.hpp"
#include "bozzetto/tool/stroke.hpp"
#include "ui/freeform.hpp"

namespace bozzetto::ui {

enum class Icon {
  add,
  carve,
  erase,
  smooth,
  paint,
  softPaint,
  stamp,
  hold,
  push,
  grip,
  swell,
  stiffen,
  soften,
  shelf
};

struct ToolRow {
  ActionKind action;
  Icon icon;
  std::string_view title;  ///< "Add clay"
  std::string_view verb;   ///< in the status line
  std::string_view what;   ///< one line on the card
  ActionKind inverse;      ///< with the inverting key held; its own action when there is none
  bool usesStrength;
  bool usesColour;
};

inline constexpr int kToolCount = 14;
std::span<const ToolRow, kToolCount> toolTable();
const ToolRow& rowOf(ActionKind action);

/// What an action's strength is called, and what it does.
struct Strengths {
  std::string_view name, what;
};
Strengths strengthsOf(ActionKind action);

/// How the tool's own y axis stands.
enum class Alignment { world, normal, view };

/// What a drag on empty ground does.
enum class EmptyDrag { sculpt, orbit };

struct PressureCurve {
  double gamma = 1;  ///< 1 straight; above 1 softer at first
  double least = 0;  ///< what the lightest touch gives
  double operator()(double pressure) const;
};

struct SculptState {
  ActionKind action = ActionKind::add;
  double size = 8;                  ///< world units: the largest radius, the limit of influence
  glm::dvec3 proportions{1, 1, 1};  ///< of the radii; the largest is 1
  Shape shape = Shape::ellipsoid;
  Profile profile = Profile::wyvill;
  glm::dquat rotation{1, 0, 0, 0};
  Alignment alignment = Alignment::normal;
  /// By action, in ActionKind's order; of a push: how far it sinks, in radii (`Press`).
  std::array<double, kToolCount> strength{0.35, 0.35, 1,   1,   0.6, 0.6, 0.8,
                                          1,    1,    0.5, 0.5, .25, 1,   0.5};
  double depth = 0;  ///< of the tool's centre over the surface, in radii
  Colour colour, second{0xdc, 0xcb, 0xaa};

  double spacing = 0.25;  ///< between dabs, × the smallest radius
  bool steady = false;
  double rope = 40;  ///< pixels
  bool pressureStrength = true, pressureSize = false;
  PressureCurve curve;
  Symmetry symmetry;
  Placement placement;

  std::optional<Freeform> freeform;  ///< the sculpture in the hand; counts where the shape says so
  bool ownColours = false;           ///< adds and paints with the sculpture's colours
  StampOptions stamp;
  clay::Settings clay;  ///< how clay gives way to what moves it
  /// All layers in the order in which they run or, while they are off, would run.
  std::vector<clay::LayerKind> layerOrder;

  bool air = true;  ///< strokes may start in empty air
  EmptyDrag emptyDrag = EmptyDrag::sculpt;

  /// Strokes bring back this state of the history instead of what the action does.
  std::optional<StepNumber> recall;
  double recallStrength = 0.7;

  /// Holding and letting go share one.
  double& strengthOf(ActionKind kind) { return strength[placeOf(kind)]; }
  double strengthOf(ActionKind kind) const { return strength[placeOf(kind)]; }
  glm::dvec3 radii() const { return proportions * size; }

  /// The tool standing on a surface with this normal, seen from `towardsViewer`.
  ToolShape tool(const glm::dvec3& normal, const glm::dvec3& towardsViewer) const;
  /// The same as an operation.
  ToolOperation toolOperation(const ToolShape& made) const;
  ActionOptions options(ActionKind kind) const;
  /// The rotation with which a dab stands on a surface with this normal.
  glm::dquat standing(const ToolShape& made, const glm::dvec3& normal) const;
  /// The side of it that meets the clay, in its own frame.
  static glm::dvec3 contactOf(const ToolShape& made);
  bool isFreeform() const { return shape == Shape::freeform && freeform.has_value(); }
  /// Takes a sculpture in the hand, in its own size where that fits cells of `cell`, or a preset,
  /// and does what it was kept with.
  void take(const Freeform& taken, double cell);
  /// Lets go of the sculpture.
  void drop();
  /// Operations that bring back what the hand does, without its tool, and the one for that;
  /// a sculpture will be kept as `from`.
  std::vector<std::string> preset() const;
  std::string presetOfTool(const std::string& from) const;
  /// What strokes do with this kind, or with the past.
  ActionOperation operation(ActionKind kind) const;
  /// A stroke that starts at this point.
  Stroke strokeFrom(const StrokePoint& first) const;
  /// Whether it moves clay: pressure is depth there, and the tool stands as the stroke began.
  bool leads(ActionKind now) const;
  /// The same as that action draws it: what plays no part is left out.
  Stroke strokeBy(ActionKind now, const StrokePoint& first) const;
  StrokePoint pointBy(ActionKind now, StrokePoint point) const;

 private:
  void takePlain(const ToolShape& taken, double cell);
  void takeUse(const Operation& operation, double cell);
  static std::size_t placeOf(ActionKind kind) {
    return std::size_t(kind == ActionKind::free ? ActionKind::hold : kind);
  }
  ToolShape freeformTool(const glm::dvec3& towardsViewer) const;
};

/// The action that a stroke does with these keys held.
enum class Held { nothing, invert, smooth, hold };
ActionKind actionFor(ActionKind chosen, Held held);

/// Clay colours to choose from.
std::span<const Colour, 14> clayColours();

}  // namespace bozzetto::ui
