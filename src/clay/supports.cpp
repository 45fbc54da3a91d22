#include "clay/supports.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "bozzetto/base/text.hpp"
#include "bozzetto/clay/thin_support.hpp"
#include "bozzetto/tool/relative.hpp"

namespace bozzetto::clay {
namespace {

constexpr double kThinnest = 2;  // cells

DabPose poseOf(const Support& support, double spacing) {
  const Key origin = cellOf(support.centre, spacing, "support centre");
  return {origin, relativeTo(origin, support.centre, spacing),
          glm::mat3_cast(normalisedRotation(support.rotation)),
          metRadii(support, spacing) / spacing};
}

}  // namespace

glm::dvec3 metRadii(const Support& support, double spacing) {
  if (support.shape == Shape::freeform) return support.radii;
  return glm::max(support.radii, glm::dvec3(kThinnest / 2 * spacing));
}

PlacedTool place(std::unique_ptr<Solid> solid, const DabPose& pose, Role role) {
  PlacedTool tool;
  tool.solid = std::move(solid);
  tool.box = grown(dabBox(pose), 1);
  tool.role = role;
  tool.radius = std::max({pose.radii.x, pose.radii.y, pose.radii.z});
  tool.core = std::min({pose.radii.x, pose.radii.y, pose.radii.z});
  return tool;
}

std::vector<PlacedTool> placeSupports(const std::vector<Support>& supports, double spacing) {
  std::vector<PlacedTool> placed;
  for (const Support& support : supports) {
    const DabPose pose = poseOf(support, spacing);
    auto solid = support.shape == Shape::freeform ? makeSolid(support.sculpture, pose)
                                                  : makeSolid(support.shape, pose);
    placed.push_back(place(std::move(solid), pose, Role::support));
  }
  return placed;
}

bool operator==(const Support& a, const Support& b) {
  if (a.shape != b.shape || a.centre != b.centre || a.radii != b.radii || a.rotation != b.rotation)
    return false;
  if (a.shape != Shape::freeform || a.sculpture == b.sculpture) return true;
  if (!a.sculpture || !b.sculpture) return false;
  return a.sculpture->scale() == b.sculpture->scale() &&
         fieldHash(a.sculpture->clay()) == fieldHash(b.sculpture->clay());
}

void requireValid(const Support& support) {
  normalisedRotation(support.rotation);
  if (support.shape == Shape::freeform && !support.sculpture)
    throw Error("support: freeform without a sculpture found, one expected");
  for (int axis = 0; axis < 3; ++axis)
    if (!(support.radii[axis] > 0) || !std::isfinite(support.radii[axis])) {
      throw Error("support radius: " + std::to_string(support.radii[axis]) +
                  " found, a number above 0 expected");
    }
}

void requireInWorkspace(const Support& support, double spacing) {
  const DabPose pose = poseOf(support, spacing);
  try {
    dabBox(pose);
  } catch (const Error& error) {
    throw Error(std::string("support: ") + error.what());
  }
}

std::string noticeOf(const Support& support, double spacing) {
  if (metRadii(support, spacing) == support.radii) return {};
  const double thickness = 2 * std::min({support.radii.x, support.radii.y, support.radii.z});
  return "support of " + numberText(thickness / spacing) +
         " cells widened to 2: clay would go through a thinner one";
}

}  // namespace bozzetto::clay
