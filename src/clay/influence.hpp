// How much each moving tool leads a piece of clay (Dewaele §3.1.1), from pseudo-distances.
#pragma once
#include <vector>

namespace bozzetto::clay {

/// Between two tools: 1 at the first, 0 at the second, in between by k = (d₁ − d₂)/d₁₂; beyond
/// either, what it is there. w = (1 − k)/2.
inline float leadOf(float first, float second, float between) {
  const float k = (first - second) / between;
  return k < -1 ? 1.0f : k > 1 ? 0.0f : (1 - k) * 0.5f;
}

/// Weights of any number of tools: products of leadOf over the others, normalised; the paper's rule
/// for two. `between[t·n + u]`; infinite distances lead nowhere. Sums to 1 or is all 0.
void shareLead(const std::vector<float>& distance, const std::vector<float>& between,
               std::vector<float>& weight);

/// From 0 to 1, level at both ends.
inline float eased(float x) { return x * x * (3 - 2 * x); }

/// How much of what it does not follow by itself clay is dragged along next to a grip: all of it
/// where the grip is, nothing `reach` away. Without, clay tears where the grip ends.
inline float dragAt(float distance, float reach) {
  return distance <= 0 ? 1.0f : distance >= reach ? 0.0f : eased(1 - distance / reach);
}

}  // namespace bozzetto::clay
