// Surfaces for tests, and what they are compared by.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "bozzetto/mesh/check.hpp"
#include "bozzetto/surface/statistics.hpp"
#include "bozzetto/surface/welded.hpp"
#include "field/test_fields.hpp"

namespace bozzetto::testing {

template <int Side>
Surface<Side> surfaceOf(const Field<Side>& field) {
  Surface<Side> surface;
  surface.rebuild(field);
  return surface;
}

/// Equal patches at equal keys, `offset` blocks apart, bit for bit.
template <int Side>
::testing::AssertionResult samePatches(const Surface<Side>& a, const Surface<Side>& b,
                                       Key offset = {}) {
  if (a.patches().nodeCount() != b.patches().nodeCount())
    return ::testing::AssertionFailure()
           << a.patches().nodeCount() << " patches against " << b.patches().nodeCount();
  auto other = b.patches().begin();
  for (const auto& [key, run] : a.patches()) {
    if (other->first != key + offset)
      return ::testing::AssertionFailure() << "patch at " << toText(key + offset) << " missing";
    if (!run.block->content().sameAs(other->second.block->content()))
      return ::testing::AssertionFailure() << "patch " << toText(key) << " differs";
    ++other;
  }
  return ::testing::AssertionSuccess();
}

/// A field from values in a box, whatever they are.
template <int Side>
Field<Side> fieldOf(int size, const std::function<float(Key)>& value) {
  Field<Side> field;
  fill<Side>(field, {{0, 0, 0}, {size - 1, size - 1, size - 1}}, value);
  return field;
}

inline ::testing::AssertionResult solid(const TriangleMesh& mesh) {
  const MeshReport r = checkMesh(mesh);
  if (isSolid(r)) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << r.triangles << " triangles, open " << r.openEdges << ", crowded " << r.crowdedEdges
         << ", unbalanced " << r.unbalancedEdges << ", repeated " << r.repeatedEdges << ", pinched "
         << r.pinchedVertices << ", degenerate " << r.degenerateTriangles;
}

}  // namespace bozzetto::testing
