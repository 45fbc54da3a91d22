// World positions as cells from the cell of a first position: strokes and fills are computed in
// these, so that a move by whole cells changes no bit (where the numbers are dyadic).
#pragma once
#include <string>
#include <string_view>

#include "bozzetto/tool/potential.hpp"

namespace bozzetto {

/// The cell of a world position. Throws Error, naming `what`, when it is not finite or beyond the
/// workspace.
Key cellOf(const glm::dvec3& position, double spacing, std::string_view what);

/// "[1, 2, 3]", for error texts.
std::string toText(const glm::dvec3& numbers);

/// A world position in cells from `origin`.
glm::dvec3 relativeTo(Key origin, const glm::dvec3& position, double spacing);

}  // namespace bozzetto
