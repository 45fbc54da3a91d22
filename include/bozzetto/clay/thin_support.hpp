// Supports as clay meets them: none is thinner than two cells, or clay would go through.
#pragma once
#include "bozzetto/clay/stroke.hpp"

namespace bozzetto::clay {

/// Its radii in world units on a grid of that spacing: at least a cell, but for sculptures.
glm::dvec3 metRadii(const Support& support, double spacing);

}  // namespace bozzetto::clay
