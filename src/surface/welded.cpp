#include "bozzetto/surface/welded.hpp"

#include <limits>

#include "bozzetto/base/error.hpp"
#include "bozzetto/base/parallel.hpp"
#include "surface/vertex_numbers.hpp"

namespace bozzetto {
namespace {

template <int Side>
class Welder {
 public:
  using Entry = typename VertexNumbers<Side>::Entry;

  Welder(const VertexNumbers<Side>& numbers, double spacing, TriangleMesh& mesh)
      : numbers_(numbers), spacing_(spacing), mesh_(mesh) {
    mesh_.positions.resize(numbers.vertexCount());
    mesh_.normals.resize(numbers.vertexCount());
    mesh_.colours.resize(numbers.vertexCount());
    mesh_.triangles.resize(numbers.triangleCount());
  }

  void addVertices(const Entry& entry) const {
    const PatchContent content = entry.patch->content();
    const Key first = BlockGeometry<Side>::firstCornerOf(entry.key);
    for (std::size_t n = 0; n < content.owned; ++n) {
      const PatchVertex& vertex = content.vertices[n];
      const std::size_t number = entry.firstVertex + n;
      for (const Axis axis : kAxes) {
        mesh_.positions[number][index(axis)] =
            (first[axis] + static_cast<double>(vertex.position[index(axis)])) * spacing_;
      }
      const auto normal = octahedralNormal(vertex.normal);
      mesh_.normals[number] = {normal[0], normal[1], normal[2]};
      mesh_.colours[number] = {vertex.colour[0], vertex.colour[1], vertex.colour[2]};
    }
  }

  void addTriangles(const Entry& entry, std::vector<std::size_t>& numbers) const {
    numbers_.numbersOf(entry, numbers);
    const auto indices = entry.patch->content().indices;
    for (std::size_t n = 0; n < indices.size(); ++n) {
      mesh_.triangles[entry.firstTriangle + n / 3][n % 3] =
          static_cast<std::uint32_t>(numbers[indices[n]]);
    }
  }

 private:
  const VertexNumbers<Side>& numbers_;
  double spacing_;
  TriangleMesh& mesh_;
};

}  // namespace

template <int Side>
TriangleMesh weld(const Surface<Side>& surface, const FieldScale& scale) {
  const VertexNumbers<Side> numbers(surface);
  if (numbers.vertexCount() > std::numeric_limits<std::uint32_t>::max()) {
    throw Error("surface: " + std::to_string(numbers.vertexCount()) +
                " vertices, at most 2^32 - 1 in one mesh expected");
  }
  TriangleMesh mesh;
  const Welder<Side> welder(numbers, scale.spacing, mesh);
  const auto& entries = numbers.entries();
  parallelFor(entries.size(), Side == 8 ? 64 : 2048, [&](std::size_t begin, std::size_t end) {
    std::vector<std::size_t> scratch;
    for (std::size_t n = begin; n < end; ++n) {
      welder.addVertices(entries[n]);
      welder.addTriangles(entries[n], scratch);
    }
  });
  return mesh;
}

template TriangleMesh weld(const Surface<1>&, const FieldScale&);
template TriangleMesh weld(const Surface<8>&, const FieldScale&);

}  // namespace bozzetto
