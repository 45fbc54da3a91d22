#include "bozzetto/io/obj.hpp"
#include "bozzetto/mesh/check.hpp"
#include "io/mesh_precision.hpp"
#include "io/number_text.hpp"

namespace bozzetto {
namespace {

void appendVertex(std::string& text, const TriangleMesh& mesh, std::size_t v, bool doubles) {
  text += 'v';
  if (doubles) {
    appendVector(text, mesh.positions[v]);
  } else {
    appendVector(text, glm::vec3(mesh.positions[v]));
  }
  if (!mesh.colours.empty()) {
    const auto c = mesh.colours[v];
    appendVector(text, glm::vec3(c.r, c.g, c.b) / 255.0f);
  }
  text += '\n';
}

void appendFace(std::string& text, const TriangleMesh::Triangle& t, bool normals) {
  text += 'f';
  for (const auto v : t) {
    text += ' ';
    appendNumber(text, v + 1);
    if (!normals) continue;
    text += "//";
    appendNumber(text, v + 1);
  }
  text += '\n';
}

}  // namespace

Bytes writeObj(const TriangleMesh& mesh, Progress& progress) {
  validate(mesh);
  const bool doubles = needsDouble(mesh), normals = !mesh.normals.empty();
  std::string text = "# bozzetto\n";
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (v % 65536 == 0)
      progress.step("Writing OBJ", 0.5 * double(v) / double(mesh.positions.size()));
    appendVertex(text, mesh, v, doubles);
  }
  for (const auto& n : mesh.normals) {
    text += "vn";
    appendVector(text, n);
    text += '\n';
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (t % 65536 == 0) {
      progress.step("Writing OBJ", 0.5 + 0.5 * double(t) / double(mesh.triangles.size()));
    }
    appendFace(text, mesh.triangles[t], normals);
  }
  const auto raw = std::as_bytes(std::span(text.data(), text.size()));
  return {raw.begin(), raw.end()};
}

}  // namespace bozzetto
