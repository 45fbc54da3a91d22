#include "bozzetto/mesh/decimate.hpp"

#include <meshoptimizer.h>

#include <cmath>

#include "bozzetto/base/error.hpp"

namespace bozzetto {
namespace {

constexpr std::uint32_t kUnused = ~std::uint32_t{0};

// Relative to the first vertex, so that far-away meshes keep their digits in float.
std::vector<glm::vec3> localPositions(const TriangleMesh& mesh) {
  std::vector<glm::vec3> local;
  local.reserve(mesh.positions.size());
  for (const glm::dvec3& p : mesh.positions) local.emplace_back(p - mesh.positions.front());
  return local;
}

template <class T>
void keepVertex(const std::vector<T>& from, std::size_t vertex, std::vector<T>& to) {
  if (!from.empty()) to.push_back(from[vertex]);
}

// Drops vertices that no triangle uses any more, keeping the order of the rest.
TriangleMesh compacted(const TriangleMesh& mesh, const std::vector<std::uint32_t>& indices) {
  std::vector<std::uint32_t> place(mesh.positions.size(), kUnused);
  for (const std::uint32_t index : indices) place[index] = 0;
  TriangleMesh result;
  for (std::size_t v = 0; v < place.size(); ++v) {
    if (place[v] == kUnused) continue;
    place[v] = static_cast<std::uint32_t>(result.positions.size());
    result.positions.push_back(mesh.positions[v]);
    keepVertex(mesh.normals, v, result.normals);
    keepVertex(mesh.colours, v, result.colours);
  }
  for (std::size_t n = 0; n < indices.size(); n += 3) {
    result.triangles.push_back({place[indices[n]], place[indices[n + 1]], place[indices[n + 2]]});
  }
  return result;
}

}  // namespace

TriangleMesh decimate(const TriangleMesh& mesh, double ratio) {
  if (!(ratio > 0 && ratio <= 1)) {
    throw Error("decimation ratio " + std::to_string(ratio) + " is not in (0, 1]");
  }
  if (ratio == 1 || mesh.triangles.empty()) return mesh;
  const std::vector<glm::vec3> positions = localPositions(mesh);
  std::vector<std::uint32_t> indices(3 * mesh.triangles.size());
  const std::size_t target =
      static_cast<std::size_t>(std::ceil(ratio * static_cast<double>(mesh.triangles.size()))) * 3;
  constexpr float anyError = 1e30f;
  const std::size_t count = meshopt_simplify(indices.data(), mesh.triangles.front().data(),
                                             indices.size(), &positions.front().x, positions.size(),
                                             sizeof(glm::vec3), target, anyError, 0, nullptr);
  indices.resize(count);
  return compacted(mesh, indices);
}

}  // namespace bozzetto
