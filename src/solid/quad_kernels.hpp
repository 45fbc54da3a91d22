// Angular springs eight quads at a time.
#pragma once
#include <span>

#include "solid/springs.hpp"

namespace bozzetto {

/// Adds −κ'(cosθ − cosθ⁰) ∂cosθ to the points of all quads.
void quadForces(const std::vector<Springs::Batch>& batches, const glm::dvec3* d, glm::dvec3* force);

/// √κ' ∂cosθ at d.
void quadTangents(const std::vector<Springs::Batch>& batches, const glm::dvec3* d,
                  std::vector<Springs::BatchTangent>& tangents);

/// Adds Σ g (g·x) over all corners.
void quadTangentTimes(const std::vector<Springs::Batch>& batches,
                      const std::vector<Springs::BatchTangent>& tangents, const glm::dvec3* x,
                      glm::dvec3* y);

}  // namespace bozzetto
