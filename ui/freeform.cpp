#include "ui/freeform.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "bozzetto/mesh/decimate.hpp"
#include "bozzetto/surface/welded.hpp"
#include "bozzetto/tool/shape.hpp"

namespace bozzetto::ui {
namespace {

constexpr double kMostTriangles = 60'000;

// A flat tool still has a little depth to put a pivot in.
glm::dvec3 halfOf(const Sculpture& sculpture) {
  return glm::max(sculpture.halfExtents() - 1.0, 0.5);
}

}  // namespace

glm::dvec3 Freeform::pivot() const { return sculpture->pivot() / halfOf(*sculpture); }

void Freeform::setPivot(const glm::dvec3& halves) {
  source.pivot = (kept->centre() + halves * halfOf(*kept)) * kept->scale().spacing;
  stand();
}

void Freeform::setContact(const glm::dvec3& direction) {
  source.contact = direction;
  stand();
}

void Freeform::standAsKept() {
  source.pivot.reset();
  source.contact.reset();
  sculpture = kept;
}

void Freeform::stand() {
  SculptureOptions options;
  options.pivot = source.pivot.value_or((kept->centre() + kept->pivot()) * kept->scale().spacing);
  options.contact = source.contact.value_or(kept->contact());
  sculpture = std::make_shared<Sculpture>(kept->clay(), options);
}

Heading headingOf(const glm::dvec3& direction) {
  const glm::dvec3 way = glm::normalize(direction);
  return {glm::degrees(std::atan2(way.x, -way.z)),
          glm::degrees(std::asin(std::clamp(way.y, -1.0, 1.0)))};
}

glm::dvec3 directionOf(const Heading& heading) {
  const double right = glm::radians(heading.right), up = glm::radians(heading.up);
  return {std::cos(up) * std::sin(right), std::sin(up), -std::cos(up) * std::cos(right)};
}

std::shared_ptr<const ToolMesh> meshOf(const Sculpture& sculpture) {
  Surface<8> surface;
  surface.rebuild(sculpture.clay());
  FieldScale cells = sculpture.scale();
  cells.spacing = 1;
  TriangleMesh mesh = weld(surface, cells);
  const double keep = kMostTriangles / double(std::max<std::size_t>(mesh.triangles.size(), 1));
  if (keep < 1) mesh = decimate(mesh, keep);
  const glm::dvec3 origin = sculpture.centre();
  auto made = std::make_shared<ToolMesh>();
  for (const glm::dvec3& position : mesh.positions) made->positions.emplace_back(position - origin);
  made->normals = std::move(mesh.normals);
  for (const auto& triangle : mesh.triangles)
    made->indices.insert(made->indices.end(), triangle.begin(), triangle.end());
  return made;
}

Freeform freeformOf(const ShelfTool& tool, const ToolSource& source,
                    std::shared_ptr<const Sculpture> sculpture) {
  Freeform made{tool.name, source, sculpture, nullptr, 8, tool.preset, sculpture};
  if (sculpture == nullptr) return made;
  const glm::dvec3 radii = freeformRadii(*sculpture, glm::dvec3(1));
  made.mesh = meshOf(*sculpture);
  made.size = std::max({radii.x, radii.y, radii.z});
  return made;
}

}  // namespace bozzetto::ui
