#include "bozzetto/tool/shape.hpp"

#include <array>
#include <cmath>

#include "bozzetto/base/axis.hpp"
#include "bozzetto/base/error.hpp"
#include "bozzetto/base/text.hpp"
#include "bozzetto/tool/sculpture.hpp"
#include "tool/freeform.hpp"

namespace bozzetto {
namespace {

constexpr std::array<std::string_view, 5> kShapes{"ellipsoid", "box", "cylinder", "capsule",
                                                  "freeform"};
constexpr std::array<std::string_view, 2> kProfiles{"wyvill", "box"};

template <class Value, std::size_t Count>
std::optional<Value> named(const std::array<std::string_view, Count>& names,
                           std::string_view name) {
  for (std::size_t n = 0; n < Count; ++n)
    if (names[n] == name) return static_cast<Value>(n);
  return std::nullopt;
}

}  // namespace

std::string_view toText(Shape shape) { return kShapes[static_cast<std::size_t>(shape)]; }
std::string_view toText(Profile profile) { return kProfiles[static_cast<std::size_t>(profile)]; }
std::optional<Shape> shapeNamed(std::string_view name) { return named<Shape>(kShapes, name); }
std::optional<Profile> profileNamed(std::string_view name) {
  return named<Profile>(kProfiles, name);
}

glm::dquat normalisedRotation(const glm::dquat& rotation) {
  const double length = std::sqrt(glm::dot(rotation, rotation));
  if (!std::isfinite(length) || length < 1e-6 || length > 1e6) {
    throw Error("rotation: a quaternion of length " + numberText(length) +
                " found, one that can be normalised expected");
  }
  return rotation / length;
}

namespace {

void requireAboveZero(const glm::dvec3& numbers, const char* what) {
  for (const Axis axis : kAxes) {
    const double number = numbers[index(axis)];
    if (number > 0 && std::isfinite(number)) continue;
    throw Error(std::string("tool ") + what + ": " + numberText(number) + " found on axis " +
                "xyz"[index(axis)] + ", a number above 0 expected");
  }
}

}  // namespace

void requireValid(const ToolShape& shape) {
  const bool sculpted = shape.shape == Shape::freeform;
  requireAboveZero(sculpted ? shape.scale : shape.radii, sculpted ? "scale" : "radius");
  normalisedRotation(shape.rotation);
}

glm::dvec3 freeformRadii(const Sculpture& sculpture, const glm::dvec3& scale) {
  requireAboveZero(scale, "scale");
  return sculpture.halfExtents() * (scale * sculpture.scale().spacing);
}

namespace {

ToolShape withOwnRadii(ToolShape shape, double spacing) {
  if (shape.shape != Shape::freeform) return shape;
  if (shape.sculpture == nullptr) throw Error("freeform tool: no sculpture found, one expected");
  shape.radii = freeformRadii(*shape.sculpture, shape.scale);
  const double smaller = minification(*shape.sculpture, shape.radii / spacing);
  if (!(smaller <= kMostMinified)) {
    throw Error("freeform tool: " + numberText(smaller) +
                " of its cells to one of the clay found, at most 256 expected");
  }
  return shape;
}

}  // namespace

FittedTool fitTool(const ToolShape& asked, double spacing) {
  requireValid(asked);
  const ToolShape shape = withOwnRadii(asked, spacing);
  FittedTool fitted{shape, {}};
  fitted.shape.rotation = normalisedRotation(shape.rotation);
  double smallest = shape.radii[0] / spacing, corners = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double cells = shape.radii[axis] / spacing;
    if (!(cells <= kLargestToolCells)) {
      throw Error("tool radius: " + numberText(shape.radii[axis]) + " found, a number in 0 < r ≤ " +
                  numberText(kLargestToolCells * spacing) + " (4096 cells) expected");
    }
    smallest = std::fmin(smallest, cells);
    corners *= 2 * cells;
    if (shape.shape == Shape::freeform) continue;
    fitted.shape.radii[axis] = std::fmax(shape.radii[axis], kSmallestToolCells * spacing);
  }
  if (corners > kMostToolCorners) {
    throw Error("tool: covers " + numberText(corners) +
                " corners, at most 2^29 expected: fill, or a coarser grid, serves such sizes");
  }
  if (smallest < kSmallestToolCells && shape.shape != Shape::freeform) {
    fitted.notice = "tool radius of " + numberText(smallest) +
                    " cells widened to 2: the grid does not sample narrower tools";
  }
  return fitted;
}

}  // namespace bozzetto
