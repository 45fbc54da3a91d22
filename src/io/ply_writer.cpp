#include <string>

#include "bozzetto/io/ply.hpp"
#include "bozzetto/mesh/check.hpp"
#include "io/mesh_precision.hpp"

namespace bozzetto {
namespace {

std::string headerOf(const TriangleMesh& mesh, bool doubles) {
  const auto property = [](const char* type, std::initializer_list<const char*> names) {
    std::string lines;
    for (const char* name : names) lines += std::string("property ") + type + " " + name + "\n";
    return lines;
  };
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment bozzetto\n";
  text += "element vertex " + std::to_string(mesh.positions.size()) + "\n";
  text += property(doubles ? "double" : "float", {"x", "y", "z"});
  if (!mesh.normals.empty()) text += property("float", {"nx", "ny", "nz"});
  if (!mesh.colours.empty()) text += property("uchar", {"red", "green", "blue"});
  text += "element face " + std::to_string(mesh.triangles.size()) + "\n";
  return text + "property list uchar int vertex_indices\nend_header\n";
}

}  // namespace

Bytes writePly(const TriangleMesh& mesh, Progress& progress) {
  validate(mesh);
  const bool doubles = needsDouble(mesh);
  ByteWriter out;
  out.put(headerOf(mesh, doubles));
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (v % 65536 == 0)
      progress.step("Writing PLY", 0.5 * double(v) / double(mesh.positions.size()));
    for (int axis = 0; axis < 3; ++axis) {
      const double x = mesh.positions[v][axis];
      doubles ? out.put(x) : out.put(static_cast<float>(x));
    }
    for (int axis = 0; axis < 3 && !mesh.normals.empty(); ++axis) out.put(mesh.normals[v][axis]);
    if (mesh.colours.empty()) continue;
    for (const auto channel : {mesh.colours[v].r, mesh.colours[v].g, mesh.colours[v].b}) {
      out.put(channel);
    }
  }
  for (const auto& t : mesh.triangles) {
    out.put(std::uint8_t{3});
    for (const auto v : t) out.put(static_cast<std::int32_t>(v));
  }
  progress.step("Writing PLY", 1);
  return out.take();
}

}  // namespace bozzetto
