#include <glm/geometric.hpp>

#include "bozzetto/io/stl.hpp"
#include "bozzetto/mesh/check.hpp"
#include "io/mesh_precision.hpp"

namespace bozzetto {
namespace {

void putVector(ByteWriter& out, const glm::vec3& v) {
  for (int axis = 0; axis < 3; ++axis) out.put(v[axis]);
}

glm::vec3 faceNormal(const TriangleMesh& mesh, const TriangleMesh::Triangle& t) {
  const auto a = mesh.positions[t[0]];
  const auto n = glm::cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
  const double length = glm::length(n);
  return length > 0 ? glm::vec3(n / length) : glm::vec3(0);
}

}  // namespace

Bytes writeStl(const TriangleMesh& mesh, Progress& progress) {
  validate(mesh);
  requireFloatRange(mesh, "STL");
  ByteWriter out;
  std::string header = "bozzetto";  // anything but "solid"
  header.resize(80, ' ');
  out.put(std::string_view(header));
  out.put(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (std::size_t n = 0; n < mesh.triangles.size(); ++n) {
    if (n % 65536 == 0) progress.step("Writing STL", double(n) / double(mesh.triangles.size()));
    const auto& t = mesh.triangles[n];
    putVector(out, faceNormal(mesh, t));
    for (const auto v : t) putVector(out, glm::vec3(mesh.positions[v]));
    out.put(std::uint16_t{0});
  }
  return out.take();
}

}  // namespace bozzetto
