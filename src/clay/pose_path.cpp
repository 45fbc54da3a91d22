#include "clay/pose_path.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace bozzetto::clay {
namespace {

double rounded(double x, double unit) { return std::nearbyint(x / unit) * unit; }

double angleBetween(const glm::dquat& a, const glm::dquat& b) {
  return 2 * std::acos(std::min(1.0, std::abs(glm::dot(a, b))));
}

}  // namespace

PosePath::PosePath(std::vector<Pose> poses, double radius, double step)
    : poses_(std::move(poses)), step_(step) {
  double sum = 0;
  for (std::size_t n = 0; n < poses_.size(); ++n) {
    if (n > 0) {
      const Pose &a = poses_[n - 1], &b = poses_[n];
      const double angle = angleBetween(a.rotation, b.rotation);
      const double turned = angle > 1e-7 ? angle * radius : 0.0;
      sum += glm::length(b.position - a.position) + turned;
    }
    distance_.push_back(sum);
  }
}

double PosePath::count() const {
  return std::ceil(rounded(distance_.back(), 0x1p-16) / step_ - 1e-6);
}

Pose PosePath::at(double steps) const {
  const double distance = std::min(steps * step_, distance_.back());
  const auto after = std::lower_bound(distance_.begin(), distance_.end(), distance);
  const auto n = static_cast<std::size_t>(after - distance_.begin());
  if (n == 0) return poses_.front();
  const double t = (distance - distance_[n - 1]) / (distance_[n] - distance_[n - 1]);
  Pose pose{glm::mix(poses_[n - 1].position, poses_[n].position, t),
            glm::slerp(poses_[n - 1].rotation, poses_[n].rotation, t)};
  for (int axis = 0; axis < 3; ++axis) {
    pose.position[axis] = rounded(pose.position[axis], 0x1p-16);
    pose.rotation[axis] = rounded(pose.rotation[axis], 0x1p-24);
  }
  pose.rotation.w = rounded(pose.rotation.w, 0x1p-24);
  pose.rotation = glm::normalize(pose.rotation);
  return pose;
}

}  // namespace bozzetto::clay
