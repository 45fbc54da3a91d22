// Places carried along with a wrap's lattice, the map by which applyWrap carries clay: to show how
// clay would follow a pose before it does.
#pragma once
#include <memory>
#include <span>

#include "bozzetto/solid/lattice.hpp"

namespace bozzetto {

/// Where a place lies in a wrap's lattice at rest. Without a piece: outside.
struct WrapPlace {
  Id piece = kNoId;
  glm::dvec3 uvw{0.5};

  bool isInside() const { return piece != kNoId; }
};

class WrapMap {
 public:
  /// Of a lattice at rest, refined so often, over a grid of that spacing. Throws Error for lattices
  /// that leave the workspace.
  WrapMap(const Lattice& rest, int levels, double spacing);
  ~WrapMap();
  WrapMap(WrapMap&&) noexcept;
  WrapMap& operator=(WrapMap&&) noexcept;

  /// Finds a place in cells; `near` is what a neighbour gave. Some 0.5 µs; from any threads.
  WrapPlace find(const glm::dvec3& cell, const WrapPlace& near = {}) const;

  /// The control points are here now, world units. Begins at rest.
  void pose(std::span<const glm::dvec3> control);
  /// Where an inside place is now, in cells. Some 50 ns; from any threads, as is `turned`.
  glm::dvec3 carried(const WrapPlace& place) const;
  /// A surface's normal there, as it is now; length 1.
  glm::dvec3 turned(const WrapPlace& place, const glm::dvec3& normal) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace bozzetto
