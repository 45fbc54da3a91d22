#include <string>

#include "bozzetto/io/inventor.hpp"
#include "bozzetto/mesh/check.hpp"
#include "io/mesh_precision.hpp"
#include "io/number_text.hpp"

namespace bozzetto {
namespace {

// One vector a line.
template <class Vectors>
void appendVectors(std::string& text, const char* field, const Vectors& vectors) {
  text += std::string("      ") + field + " [\n";
  for (const auto& v : vectors) {
    appendVector(text, glm::vec3(v));
    text += ",\n";
  }
  text += "      ]\n";
}

// 0xrrggbbaa
void appendColours(std::string& text, const std::vector<Colour>& colours) {
  text += "      orderedRGBA [\n";
  for (const auto& colour : colours) text += "0x" + toText(colour).substr(1) + "ff,\n";
  text += "      ]\n      materialBinding PER_VERTEX_INDEXED\n";
}

void appendFaces(std::string& text, const TriangleMesh& mesh, Progress& progress) {
  text += "    coordIndex [\n";
  for (std::size_t n = 0; n < mesh.triangles.size(); ++n) {
    if (n % 65536 == 0) {
      progress.step("Writing Inventor", double(n) / double(mesh.triangles.size()));
    }
    for (const auto v : mesh.triangles[n]) {
      appendNumber(text, v);
      text += ',';
    }
    text += "-1,\n";
  }
  text += "    ]\n";
}

}  // namespace

Bytes writeInventor(const TriangleMesh& mesh, Progress& progress) {
  validate(mesh);
  requireFloatRange(mesh, "Inventor");
  std::string text =
      "#Inventor V2.1 ascii\n\nSeparator {\n"
      "  ShapeHints {\n    vertexOrdering COUNTERCLOCKWISE\n    faceType CONVEX\n  }\n"
      "  IndexedFaceSet {\n    vertexProperty VertexProperty {\n";
  appendVectors(text, "vertex", mesh.positions);
  if (!mesh.normals.empty()) {
    appendVectors(text, "normal", mesh.normals);
    text += "      normalBinding PER_VERTEX_INDEXED\n";
  }
  if (!mesh.colours.empty()) appendColours(text, mesh.colours);
  text += "    }\n";
  appendFaces(text, mesh, progress);
  text += "  }\n}\n";
  const auto raw = std::as_bytes(std::span(text.data(), text.size()));
  return {raw.begin(), raw.end()};
}

}  // namespace bozzetto
