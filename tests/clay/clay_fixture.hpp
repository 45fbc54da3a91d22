// What tests of clay share: bodies to work on, strokes, and what is measured afterwards.
#pragma once
#include <gtest/gtest.h>

#include <cmath>

#include "bozzetto/clay/stroke.hpp"
#include "bozzetto/tool/fill.hpp"
#include "clay/pieces.hpp"

namespace bozzetto::clay::testing {

inline void addSolid(Clay& clay, Shape shape, glm::dvec3 centre, glm::dvec3 radii,
                     Colour colour = {}) {
  Edit<CornerBlock<8>> edit(clay.tree);
  Primitive primitive;
  primitive.shape = shape;
  primitive.centre = centre;
  primitive.radii = radii;
  primitive.colour = colour;
  fill<8>(edit, clay.scale, primitive);
  edit.commit();
}

/// Fixes what stands in a box.
inline void holdBox(Clay& clay, Key low, Key high) {
  Edit<CornerBlock<8>> edit(clay.tree);
  for (Key key = low; key.i <= high.i; ++key.i)
    for (key.j = low.j; key.j <= high.j; ++key.j)
      for (key.k = low.k; key.k <= high.k; ++key.k) {
        if (edit.read(BlockGeometry<8>::blockOf(key)) == nullptr) continue;
        auto& block = edit.write(BlockGeometry<8>::blockOf(key));
        block.attributes[BlockGeometry<8>::indexOf(key)] |= 0xff000000;
      }
  edit.commit();
}

struct Measures {
  double mass = 0;       ///< cells
  float densest = 0;     ///< the largest value
  double volume = 0;     ///< cells, inside iso, by linear interpolation along three axes
  int pieces = 0;        ///< 6-connected, ≥ iso
  double thickness = 0;  ///< mean 1/|∇v| on the surface, cells
  std::int64_t stored = 0, faint = 0;  ///< corners; those below 0.05
  glm::dvec3 centre{0};
};

Measures measure(const Clay& clay);

/// Pieces of fewer cells than that.
int piecesBelow(const Clay& clay, int cells);

/// Corners that a clean body of this shape would store: those inside, and one ring of 26.
std::int64_t cleanCorners(const Clay& clay);

/// A stroke of a tool through points; a rotation a point or none.
struct Push {
  ToolShape tool;
  Role role = Role::push;
  Stroke stroke;
  Setup setup;
  double strength = 1;
};

inline ToolShape toolOf(Shape shape, glm::dvec3 radii) {
  ToolShape tool;
  tool.shape = shape;
  tool.radii = radii;
  return tool;
}

/// Runs it, commits, returns the number of steps; the paint as it is then, where it is asked for.
std::int64_t run(Clay& clay, const Push& push, Stiffness* moved = nullptr);

}  // namespace bozzetto::clay::testing
