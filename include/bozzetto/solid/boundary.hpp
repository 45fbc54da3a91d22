// The surface of a solid. Boundary rules of subdivision use the boundary alone, so a smoother
// surface costs four times as much a level and not eight (solid.md §3).
#pragma once
#include "bozzetto/mesh/triangle_mesh.hpp"
#include "bozzetto/solid/lattice.hpp"

namespace bozzetto {

/// The boundary as a lattice without cells: same points and tags, faces wound counter-clockwise
/// seen from outside. It refines like the solid's own boundary. O(n).
Lattice surfaceOf(const Lattice& lattice);

/// Volume inside a surface, each face the fan round its mean point: exact for bilinear quads.
double enclosedVolume(const Lattice& surface);

/// Volume of a solid, negative never: parts turned inside out count by their winding.
double volume(const Lattice& lattice);

/// Every face as triangles round its mean point, cut into `cuts`² pieces first where it is a quad
/// (1 = not cut: four triangles). Points are those of the surface, then new ones.
TriangleMesh triangulated(const Lattice& surface, int cuts = 1);

}  // namespace bozzetto
