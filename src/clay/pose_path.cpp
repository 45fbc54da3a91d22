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

PosePath::PosePath(const std::vector<Pose>& poses, double radius, double step)
    : radius_(radius), step_(step) {
  for (const Pose& pose : poses) append(pose);
}

void PosePath::append(const Pose& pose) {
  double distance = 0;
  if (!poses_.empty()) {
    const double angle = angleBetween(poses_.back().rotation, pose.rotation);
    const double turned = angle > 1e-7 ? angle * radius_ : 0.0;
    distance = distance_.back() + glm::length(pose.position - poses_.back().position) + turned;
  }
  poses_.push_back(pose);
  distance_.push_back(distance);
}

double PosePath::sure() const {
  return std::floor(rounded(distance_.back(), 0x1p-16) / step_ + 1e-6);
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
            glm::slerp(poses_[n - 1].rotation, poses_[n].rotation, t),
            rounded(glm::mix(poses_[n - 1].size, poses_[n].size, t), 0x1p-16)};
  for (int axis = 0; axis < 3; ++axis) {
    pose.position[axis] = rounded(pose.position[axis], 0x1p-16);
    pose.rotation[axis] = rounded(pose.rotation[axis], 0x1p-24);
  }
  pose.rotation.w = rounded(pose.rotation.w, 0x1p-24);
  pose.rotation = glm::normalize(pose.rotation);
  return pose;
}

}  // namespace bozzetto::clay
