#include "clay/influence.hpp"

#include <cmath>
#include <cstddef>

namespace bozzetto::clay {

void shareLead(const std::vector<float>& distance, const std::vector<float>& between,
               std::vector<float>& weight) {
  const std::size_t count = distance.size();
  float sum = 0;
  for (std::size_t t = 0; t < count; ++t) {
    weight[t] = std::isfinite(distance[t]) ? 1.0f : 0.0f;
    for (std::size_t u = 0; u < count; ++u) {
      const bool both = u != t && std::isfinite(distance[t]) && std::isfinite(distance[u]);
      if (both) weight[t] *= leadOf(distance[t], distance[u], between[t * count + u]);
    }
    sum += weight[t];
  }
  for (std::size_t t = 0; sum > 0 && t < count; ++t) weight[t] /= sum;
}

}  // namespace bozzetto::clay
