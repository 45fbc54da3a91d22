// Operations on deformable solids and on clay through them. World units throughout.
#pragma once
#include <array>
#include <optional>
#include <variant>

#include "bozzetto/solid/bake.hpp"
#include "bozzetto/solid/block.hpp"
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

}  // namespace bozzetto
