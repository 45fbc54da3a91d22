#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "bozzetto/tool/stroke.hpp"

namespace bozzetto {

StrokePath::StrokePath(std::vector<Sample> points, double step)
    : points_(std::move(points)), step_(step) {
  double along = 0;
  distance_.reserve(points_.size());
  for (std::size_t n = 0; n < points_.size(); ++n) {
    if (n > 0) along += glm::length(points_[n].position - points_[n - 1].position);
    distance_.push_back(along);
  }
}

double StrokePath::count() const {
  constexpr double slack = 1e-9;  // an end that a dab should meet exactly is met
  return 1 + std::floor(distance_.back() / step_ + slack);
}

StrokePath::Sample StrokePath::at(std::int64_t n) const {
  const double along = std::min(static_cast<double>(n) * step_, distance_.back());
  const auto after = std::upper_bound(distance_.begin(), distance_.end(), along);
  if (after == distance_.end()) return points_.back();
  const auto next = static_cast<std::size_t>(after - distance_.begin());
  const Sample &a = points_[next - 1], &b = points_[next];
  const double t = (along - distance_[next - 1]) / (distance_[next] - distance_[next - 1]);
  return {a.position + t * (b.position - a.position), a.pressure + t * (b.pressure - a.pressure)};
}

}  // namespace bozzetto
