// Operations on deformable solids and on clay through them. World units throughout.
#pragma once
#include <array>
#include <optional>
#include <variant>

#include "bozzetto/solid/bake.hpp"
#include "bozzetto/solid/block.hpp"
#include "bozzetto/solid/tools.hpp"
#include "bozzetto/solid/wrap.hpp"

namespace bozzetto {

/// A block of cubical control cells, in the place of what solid there was.
struct SolidOperation {
  BlockOptions block{{2, 2, 2}, glm::dvec3(20), glm::dvec3(0), {}};
};

/// A control point by its name in the block, or by its number.
using PointName = std::variant<Key, Id>;

struct SolidMoveOperation {
  PointName point;
  glm::dvec3 by{0};
};

/// The solid, refined, as clay.
struct BakeOperation {
  BakeOptions options;
};

/// A lattice round all the clay, or round a box.
struct WrapOperation {
  Key cells{4, 4, 4};
  std::optional<std::array<glm::dvec3, 2>> box;
};

/// Carries the clay along with the wrap's lattice, whose rest it then is.
struct WrapApplyOperation {
  WrapOptions options;
};

/// Lets go of the solid or the wrap.
struct SolidDropOperation {};

/// A coarse solid where the clay is, so many cells along its longest side.
struct SolidFromClayOperation {
  int cells = 8;
};

// The sixteen tools (McDonnell & Qin §6). Elements are those nearest to `at`.

struct SolidCarveOperation {
  glm::dvec3 at{0};
};
struct SolidExtrudeOperation {
  glm::dvec3 at{0};
  double length = 0;  ///< 0: as the cell behind
};
struct SolidJoinOperation {
  glm::dvec3 at{0}, to{0};
};
struct SolidSubdivideOperation {
  glm::dvec3 at{0};
};
struct SolidSharpOperation {
  Element element = Element::face;
  glm::dvec3 at{0};
  Sharp sharp = Sharp::yes;
};
/// The rope tool, several at once.
struct SolidPullOperation {
  std::vector<Pull> ropes;
  std::optional<double> strength;  ///< of the settings where there is none
  int steps = 20;
};
/// Physics without ropes.
struct SolidRunOperation {
  int steps = 20;
};
struct SolidSplineOperation {
  std::vector<glm::dvec3> points;
  std::vector<SplineDrag> drags;
  int steps = 20;
};
struct SolidPaintOperation {
  Matter matter = Matter::mass;
  glm::dvec3 at{0};
  double radius = 10, factor = 2;
};
/// Inflate, or deflate where negative; then physics.
struct SolidInflateOperation {
  glm::dvec3 at{0};
  double radius = 10, amount = 0.5;
  int steps = 20;
};
struct SolidTrimOperation {
  glm::dvec3 at{0};
  double radius = 10;
  TakesPart part = TakesPart::no;
};
struct SolidWindowOperation {
  std::optional<std::array<glm::dvec3, 2>> box;
};
struct SolidRestOperation {};
/// The global sliders; what is not named stays.
struct SolidSettingsOperation {
  std::optional<Solver> solver;
  std::optional<int> levels;
  std::optional<double> timeStep, damping, stiffness, angular, ropeStrength, creep;
};
/// The numbers among them: what they are called in recordings, what they are of a solid, and of
/// the operation.
struct SolidNumber {
  const char* name;
  double SolidSettings::*value;
  std::optional<double> SolidSettingsOperation::*wanted;
};
inline constexpr std::array<SolidNumber, 6> kSolidNumbers{{
    {"time_step", &SolidSettings::timeStep, &SolidSettingsOperation::timeStep},
    {"damping", &SolidSettings::damping, &SolidSettingsOperation::damping},
    {"stiffness", &SolidSettings::stiffness, &SolidSettingsOperation::stiffness},
    {"angular", &SolidSettings::angular, &SolidSettingsOperation::angular},
    {"rope_strength", &SolidSettings::ropeStrength, &SolidSettingsOperation::ropeStrength},
    {"creep", &SolidSettings::creep, &SolidSettingsOperation::creep},
}};
/// Names all of them.
SolidSettingsOperation operationOf(const SolidSettings& settings);

/// Tells stiffness and changes nothing: no step of history.
struct SolidProbeOperation {
  glm::dvec3 at{0};
  double radius = 10;
};

}  // namespace bozzetto
