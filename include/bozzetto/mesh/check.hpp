// What a triangle mesh is worth: closed, manifold, oriented, in how many parts, of what genus.
#pragma once
#include <cstddef>
#include <optional>
#include <string_view>

#include "bozzetto/mesh/triangle_mesh.hpp"

namespace bozzetto {

/// An axis-aligned box in world units; empty until a point is added.
struct MeshBounds {
  glm::dvec3 min{0}, max{0};
  bool empty = true;

  void add(const glm::dvec3& point);
  glm::dvec3 size() const { return empty ? glm::dvec3(0) : max - min; }
  double longestSide() const;
};

/// Counts over the triangles of a mesh. An edge is an unordered pair of vertices; positions are not
/// compared, so a mesh whose seams were split has open edges until it is welded.
struct MeshReport {
  std::size_t vertices = 0;  ///< used by at least one triangle
  std::size_t unusedVertices = 0;
  std::size_t triangles = 0;
  std::size_t degenerateTriangles = 0;  ///< with a repeated vertex
  std::size_t edges = 0;
  std::size_t openEdges = 0;          ///< with one triangle only
  std::size_t crowdedEdges = 0;       ///< with more than two triangles
  std::size_t unbalancedEdges = 0;    ///< not walked equally often in both directions
  std::size_t repeatedEdges = 0;      ///< walked more than once in the same direction
  std::size_t pinchedVertices = 0;    ///< whose triangles form more than one fan
  std::size_t components = 0;         ///< connected by shared vertices
  long long eulerCharacteristic = 0;  ///< vertices - edges + triangles
  double volume = 0;                  ///< signed, world units cubed; meaningful when closed
  double area = 0;
  MeshBounds bounds;  ///< of used vertices

  bool closed() const { return unbalancedEdges == 0; }
  bool oriented() const { return repeatedEdges == 0; }
  bool manifold() const {
    return crowdedEdges == 0 && pinchedVertices == 0 && degenerateTriangles == 0;
  }
  /// Handles summed over all components; nothing unless closed, oriented and manifold.
  std::optional<long long> genus() const;
};

/// Throws Error unless every index is in range, every position finite, and normals and colours are
/// absent or one per position. `name` opens the text. O(n).
void validate(const TriangleMesh& mesh, std::string_view name = "mesh");

/// All counts at once. The mesh must be valid. O(n) up to short sorts, about 0.5 s for 2.5 million
/// triangles.
MeshReport checkMesh(const TriangleMesh& mesh);

/// Signed volume in world units cubed, positive when triangles are counter-clockwise from outside.
double signedVolume(const TriangleMesh& mesh);

double surfaceArea(const TriangleMesh& mesh);

/// Of all positions, used or not.
MeshBounds boundsOf(const TriangleMesh& mesh);

/// A mesh that is closed, oriented and manifold has every directed edge exactly once, and once in
/// the opposite direction.
inline bool isSolid(const MeshReport& report) {
  return report.triangles > 0 && report.closed() && report.oriented() && report.manifold();
}

}  // namespace bozzetto
