// What lies under a pixel: rays from the camera, met by the clay itself. No OpenGL.
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "bozzetto/field/field.hpp"
#include "bozzetto/render/shot.hpp"

namespace bozzetto {

struct Ray {
  glm::dvec3 origin{0};            ///< cells
  glm::dvec3 direction{0, 0, -1};  ///< length 1
  glm::dvec3 at(double distance) const { return origin + direction * distance; }
};

/// Through a place in the picture: pixels from its upper left corner, (.5, .5) the first one's
/// middle. Starts at the eye; in orthographic views on the plane through it.
Ray rayThrough(const Shot& shot, glm::dvec2 pixel);

/// Where a place (cells) is seen: pixels from the upper left corner, and its depth along the view,
/// cells. Nothing when it lies behind the eye.
struct Seen {
  glm::dvec2 pixel{0};
  double depth = 0;
};
std::optional<Seen> seenAt(const Shot& shot, const glm::dvec3& place);

/// Cells that one pixel spans at a place.
double cellsPerPixel(const Shot& shot, const glm::dvec3& place);

struct Hit {
  glm::dvec3 place{0};        ///< on the surface, cells
  glm::vec3 normal{0, 1, 0};  ///< outward, length 1
  double distance = 0;        ///< along the ray, cells
};

/// The first place within `reach` cells where the clay's density along the ray rises to iso; a ray
/// that starts inside hits at once. Exact to 1e-3 cells on the trilinear density. O(blocks on the
/// way + cells of the blocks that hold clay): tens of microseconds.
std::optional<Hit> pick(const Clay& clay, const Ray& ray, double reach);

/// Where the ray meets the plane through `point`; nothing when it runs along it or away from it.
std::optional<glm::dvec3> meetPlane(const Ray& ray, const glm::dvec3& point,
                                    const glm::dvec3& normal);

}  // namespace bozzetto
