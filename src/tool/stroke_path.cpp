#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "bozzetto/tool/stroke.hpp"

namespace bozzetto {

StrokePath::StrokePath(const std::vector<Sample>& points, double step) : step_(step) {
  points_.reserve(points.size());
  distance_.reserve(points.size());
  for (const Sample& point : points) append(point);
}

void StrokePath::append(const Sample& point) {
  const double along =
      points_.empty() ? 0
                      : distance_.back() + glm::length(point.position - points_.back().position);
  points_.push_back(point);
  distance_.push_back(along);
}

void StrokePath::shorten(std::size_t count) {
  points_.resize(count);
  distance_.resize(count);
}

std::int64_t StrokePath::sure() const {
  auto last = static_cast<std::int64_t>(distance_.back() / step_);
  while (static_cast<double>(last) * step_ > distance_.back()) --last;
  return last + 1;
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
