// Operations on clay that behaves like clay.
#pragma once
#include "bozzetto/clay/stroke.hpp"
#include "bozzetto/sculptor/tool_operations.hpp"

namespace bozzetto {

/// How clay gives way to strokes that push and grip, from now on.
struct ClayOperation {
  clay::Settings settings;
};

/// Runs the clay's layers without a tool.
struct RelaxOperation {
  int steps = 10;
};

/// A tool that stands still from now on, for strokes that push and grip.
struct SupportOperation {
  clay::Support support;
  std::optional<ToolSource> source{};  ///< of freeform ones that bring no sculpture
  std::optional<glm::dvec3> scale{};   ///< of these: their radii follow
};

/// Puts the n-th support (from 0) elsewhere, as another one if need be. A sculpture stays the same
/// one where no source is given.
struct SupportMoveOperation {
  int number = 0;
  SupportOperation to;
};

/// Takes the n-th support (from 0) away.
struct SupportDropOperation {
  int number = 0;
};

/// Holds the clay in a box: 0 free … 1 fixed. World units, both ends belong to it.
struct HoldOperation {
  glm::dvec3 low{0}, high{0};
  double amount = 1;
};

/// Frees what is held, and takes supports and painted stiffness away.
struct ReleaseOperation {
  bool hold = true, supports = true, stiffness = true;
};

}  // namespace bozzetto
