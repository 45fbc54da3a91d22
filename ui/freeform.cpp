#include "ui/freeform.hpp"

#include <algorithm>

#include "bozzetto/mesh/decimate.hpp"
#include "bozzetto/surface/welded.hpp"
#include "bozzetto/tool/shape.hpp"

namespace bozzetto::ui {
namespace {

constexpr double kMostTriangles = 60'000;

}  // namespace

std::shared_ptr<const ToolMesh> meshOf(const Sculpture& sculpture) {
  Surface<8> surface;
  surface.rebuild(sculpture.clay());
  FieldScale cells = sculpture.scale();
  cells.spacing = 1;
  TriangleMesh mesh = weld(surface, cells);
  const double keep = kMostTriangles / double(std::max<std::size_t>(mesh.triangles.size(), 1));
  if (keep < 1) mesh = decimate(mesh, keep);
  const glm::dvec3 origin = sculpture.centre() + sculpture.pivot();
  auto made = std::make_shared<ToolMesh>();
  for (const glm::dvec3& position : mesh.positions) made->positions.emplace_back(position - origin);
  made->normals = std::move(mesh.normals);
  for (const auto& triangle : mesh.triangles)
    made->indices.insert(made->indices.end(), triangle.begin(), triangle.end());
  return made;
}

Freeform freeformOf(const ShelfTool& tool, const ToolSource& source,
                    std::shared_ptr<const Sculpture> sculpture) {
  const glm::dvec3 radii = freeformRadii(*sculpture, glm::dvec3(1));
  auto mesh = meshOf(*sculpture);
  return {tool.name,
          source,
          std::move(sculpture),
          std::move(mesh),
          std::max({radii.x, radii.y, radii.z}),
          tool.preset};
}

}  // namespace bozzetto::ui
