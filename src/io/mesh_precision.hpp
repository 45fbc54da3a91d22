// When single precision is too coarse for a mesh.
#pragma once
#include "bozzetto/mesh/triangle_mesh.hpp"

namespace bozzetto {

/// True when the mesh lies so far from the origin, beside its own size, that single precision
/// would move vertices by more than 2⁻²² of the longest side.
bool needsDouble(const TriangleMesh& mesh);

/// Throws Error unless every position fits single precision: STL and Inventor know no other.
void requireFloatRange(const TriangleMesh& mesh, const char* format);

}  // namespace bozzetto
