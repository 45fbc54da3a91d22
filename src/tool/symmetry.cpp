#include "bozzetto/tool/symmetry.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "bozzetto/base/error.hpp"
#include "tool/repeats.hpp"

namespace bozzetto {
namespace {

constexpr int kMostCopies = 256;
constexpr double kSame = 1e-9;

bool same(const glm::dvec3& a, const glm::dvec3& b) {
  return glm::length(a - b) <= kSame * (1 + glm::length(a));
}

bool same(const glm::dmat3& a, const glm::dmat3& b) {
  return same(a[0], b[0]) && same(a[1], b[1]) && same(a[2], b[2]);
}

// Turn n of `count` about an axis; quarter turns exact.
glm::dmat3 turn(Axis axis, int n, int count) {
  constexpr double exact[4] = {0, 1, 0, -1};
  const double angle = 2 * 3.14159265358979323846 * n / count;
  const bool quarter = 4 * n % count == 0;
  const int q = 4 * n / count;
  const double s = quarter ? exact[q % 4] : std::sin(angle);
  const double c = quarter ? exact[(q + 1) % 4] : std::cos(angle);
  const int a = index(next(axis)), b = index(next(next(axis)));
  glm::dmat3 matrix{1};
  matrix[a][a] = matrix[b][b] = c;
  matrix[a][b] = s;
  matrix[b][a] = -s;
  return matrix;
}

// The tool's axis `axis` as a line with a length: (axis · axisᵀ) / radius².
glm::dmat3 square(const DabPose& pose, int axis) {
  const glm::dvec3 scaled = pose.orientation[axis] / pose.radii[axis];
  return glm::outerProduct(scaled, scaled);
}

// Same position, same clay touched. An ellipsoid is its quadratic form; shapes about y are that
// and their y; a box is its set of axes; a sculpture may be like nothing but itself.
bool sameDab(const DabPose& a, const DabPose& b, Shape shape) {
  if (!same(a.position, b.position)) return false;
  if (shape == Shape::freeform) return same(a.orientation, b.orientation);
  const glm::dmat3 formA = square(a, 0) + square(a, 1) + square(a, 2);
  const glm::dmat3 formB = square(b, 0) + square(b, 1) + square(b, 2);
  if (!same(formA, formB)) return false;
  if (shape == Shape::ellipsoid) return true;
  if (shape != Shape::box) return same(square(a, 1), square(b, 1));
  return std::all_of(&kAxes[0], &kAxes[0] + 3, [&](Axis axis) {
    const glm::dmat3 side = square(a, index(axis));
    return same(side, square(b, 0)) || same(side, square(b, 1)) || same(side, square(b, 2));
  });
}

}  // namespace

void requireValid(const Symmetry& symmetry) {
  if (symmetry.radialCount < 1 || symmetry.radialCount > kMostCopies) {
    throw Error("radial count: " + std::to_string(symmetry.radialCount) +
                " found, 1 to 256 expected");
  }
  for (int axis = 0; axis < 3; ++axis)
    if (!std::isfinite(symmetry.centre[axis])) throw Error("mirror_at: a number is not finite");
}

std::vector<glm::dmat3> imagesOf(const Symmetry& symmetry) {
  std::vector<glm::dmat3> images;
  for (int n = 0; n < symmetry.radialCount; ++n) {
    for (int mirrors = 0; mirrors < 8; ++mirrors) {
      glm::dmat3 reflection{1};
      bool wanted = true;
      for (int axis = 0; axis < 3; ++axis) {
        if ((mirrors >> axis & 1) == 0) continue;
        reflection[axis][axis] = -1;
        wanted = wanted && symmetry.mirror[static_cast<std::size_t>(axis)];
      }
      if (!wanted) continue;
      const glm::dmat3 image = turn(symmetry.radialAxis, n, symmetry.radialCount) * reflection;
      const auto twin = [&](const glm::dmat3& other) { return same(other, image); };
      if (std::none_of(images.begin(), images.end(), twin)) images.push_back(image);
    }
  }
  return images;
}

std::vector<DabPose> imagesOf(const DabPose& pose, Shape shape,
                              const std::vector<glm::dmat3>& images, const glm::dvec3& centre) {
  std::vector<DabPose> poses;
  poses.reserve(images.size());
  std::size_t fixed = 0;  // images that leave the dab as it is: more than one make twins
  for (const glm::dmat3& image : images) {
    DabPose made = pose;
    made.position = centre + image * (pose.position - centre);
    made.orientation = image * pose.orientation;
    fixed += sameDab(made, pose, shape);
    poses.push_back(made);
  }
  return fixed <= 1 ? poses : withoutTwins(poses, shape);
}

std::vector<DabPose> withoutTwins(const std::vector<DabPose>& poses, Shape shape) {
  std::vector<DabPose> once;
  for (const DabPose& made : poses) {
    const auto twin = [&](const DabPose& other) { return sameDab(other, made, shape); };
    if (std::none_of(once.begin(), once.end(), twin)) once.push_back(made);
  }
  return once;
}

// Mirrors are their own inverses.
std::vector<glm::dmat3> turnsOf(const Symmetry& symmetry, const std::vector<glm::dmat3>& images) {
  Symmetry mirrors = symmetry;
  mirrors.radialCount = 1;
  glm::dvec3 axis(0);
  axis[index(symmetry.radialAxis)] = 1;
  std::vector<glm::dmat3> turns;
  for (const glm::dmat3& image : images) {
    std::optional<glm::dmat3> turn;
    for (const glm::dmat3& mirror : imagesOf(mirrors)) {
      const glm::dmat3 rest = mirror * image;
      if (!same(rest * axis, axis) || glm::determinant(rest) < 0) continue;
      if (!turn || same(rest, glm::dmat3(1))) turn = rest;
    }
    turns.push_back(turn.value_or(image));
  }
  return turns;
}

}  // namespace bozzetto
