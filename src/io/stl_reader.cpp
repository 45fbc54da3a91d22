#include <cmath>
#include <string>

#include "bozzetto/io/stl.hpp"
#include "bozzetto/mesh/weld.hpp"
#include "io/mesh_builder.hpp"
#include "io/sniff.hpp"
#include "io/text_reader.hpp"

namespace bozzetto {
namespace {

constexpr std::size_t kTriangleBytes = 50;

void appendTriangle(TriangleMesh& mesh) {
  const auto end = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.triangles.push_back({end - 3, end - 2, end - 1});
}

TriangleMesh readBinary(std::span<const std::byte> bytes, std::string_view name,
                        Progress& progress) {
  ByteReader reader(bytes, name);
  reader.skip(80);
  const std::size_t count = reader.get<std::uint32_t>();
  if (count > reader.remaining() / kTriangleBytes) {
    throw Error(std::string(name) + ": byte 80: found " + std::to_string(count) +
                " triangles, expected at most the " +
                std::to_string(reader.remaining() / kTriangleBytes) +
                " that the file has room for");
  }
  TriangleMesh mesh;
  mesh.positions.reserve(3 * count);
  mesh.triangles.reserve(count);
  for (std::size_t t = 0; t < count; ++t) {
    if (t % 65536 == 0)
      progress.step("Reading STL", static_cast<double>(t) / static_cast<double>(count));
    reader.skip(12);
    for (int corner = 0; corner < 3; ++corner) {
      glm::dvec3 p;
      for (int axis = 0; axis < 3; ++axis) p[axis] = reader.get<float>();
      if (!std::isfinite(p.x + p.y + p.z)) {
        throw Error(std::string(name) + ": byte " + std::to_string(reader.position() - 12) +
                    ": found a coordinate that is not finite, expected a number");
      }
      mesh.positions.push_back(p);
    }
    reader.skip(2);
    appendTriangle(mesh);
  }
  return mesh;
}

// facet normal x y z / outer loop / vertex x y z (three times) / endloop / endfacet
TriangleMesh readAscii(std::span<const std::byte> bytes, std::string_view name,
                       Progress& progress) {
  TextReader text(bytes, name);
  TriangleMesh mesh;
  std::size_t corners = 0;
  for (auto word = text.word(); !word.empty(); word = text.word()) {
    if (equalsIgnoringCase(word, "vertex")) {
      glm::dvec3 p;
      for (int axis = 0; axis < 3; ++axis) p[axis] = text.number();
      mesh.positions.push_back(p);
      ++corners;
    } else if (equalsIgnoringCase(word, "endloop") || equalsIgnoringCase(word, "endfacet")) {
      if (corners != 0 && corners != 3) text.fail(word, "three vertices before it");
      if (corners == 3) appendTriangle(mesh);
      corners = 0;
      if (mesh.triangles.size() % 65536 == 0) progress.step("Reading STL", text.fraction());
    } else if (equalsIgnoringCase(word, "facet")) {
      text.restOfLine();  // the normal: what the vertices say counts
    } else if (equalsIgnoringCase(word, "solid") || equalsIgnoringCase(word, "endsolid")) {
      text.restOfLine();
    } else if (!equalsIgnoringCase(word, "outer") && !equalsIgnoringCase(word, "loop")) {
      text.fail(word, "facet, vertex or endsolid");
    }
  }
  if (corners != 0) text.fail("", "endloop");
  return mesh;
}

}  // namespace

TriangleMesh readStl(std::span<const std::byte> bytes, std::string_view name, Progress& progress) {
  auto mesh =
      isBinaryStl(bytes) ? readBinary(bytes, name, progress) : readAscii(bytes, name, progress);
  requireMesh(mesh, name);
  weldVertices(mesh);
  requireMesh(mesh, name);
  return mesh;
}

}  // namespace bozzetto
