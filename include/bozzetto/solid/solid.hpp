// A solid being worked on, as a plain value: what the history remembers and a scene file holds.
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "bozzetto/solid/block.hpp"
#include "bozzetto/solid/lattice.hpp"
#include "bozzetto/solid/physics.hpp"

namespace bozzetto {

struct Solid {
  Lattice control;         ///< as it is posed now
  std::vector<Key> names;  ///< one a point: its place in the block it came from, or kNoName
  std::vector<glm::dvec3>
      wrapRest;  ///< of a wrap: its points where the clay is as it is; else empty

  SolidSettings settings;
  SolidMatter matter;

  static constexpr Key kNoName{-1, -1, -1};

  bool isWrap() const { return !wrapRest.empty(); }
  /// The point of that name. Throws Error when there is none.
  Id pointNamed(Key name) const;

  friend bool operator==(const Solid&, const Solid&) = default;
};

/// Solids are shared between the steps of history and never written.
using SolidRef = std::shared_ptr<const Solid>;

}  // namespace bozzetto
