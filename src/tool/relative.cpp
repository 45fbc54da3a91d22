#include "bozzetto/tool/relative.hpp"

#include <cmath>

#include "bozzetto/base/error.hpp"
#include "bozzetto/base/text.hpp"

namespace bozzetto {

Key cellOf(const glm::dvec3& position, double spacing, std::string_view what) {
  Key cell;
  for (const Axis axis : kAxes) {
    const double cells = std::floor(position[index(axis)] / spacing);
    if (!(std::abs(cells) <= kWorkspaceRim)) {
      throw Error(std::string(what) + ": coordinate " + numberText(position[index(axis)]) +
                  " found, one within the workspace of ±2^30 cells expected");
    }
    cell[axis] = static_cast<std::int32_t>(cells);
  }
  return cell;
}

std::string toText(const glm::dvec3& numbers) {
  return "[" + numberText(numbers.x) + ", " + numberText(numbers.y) + ", " + numberText(numbers.z) +
         "]";
}

glm::dvec3 relativeTo(Key origin, const glm::dvec3& position, double spacing) {
  const glm::dvec3 corner(origin.i, origin.j, origin.k);
  return (position - corner * spacing) / spacing;
}

}  // namespace bozzetto
