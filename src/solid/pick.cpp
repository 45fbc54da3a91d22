#include "bozzetto/solid/pick.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

namespace bozzetto {
namespace {

std::size_t countOf(const Lattice& lattice, const Topology& topology, Element element) {
  switch (element) {
    case Element::point:
      return lattice.points.size();
    case Element::edge:
      return topology.edges.size();
    case Element::face:
      return lattice.faces.size();
    case Element::cell:
      return lattice.cells.size();
  }
  return 0;
}

bool onBoundary(const Lattice& lattice, const Topology& topology, Element element, Id n) {
  switch (element) {
    case Element::point:
      return topology.boundaryPoint[n] != 0;
    case Element::edge:
      return topology.boundaryEdge[n] != 0;
    case Element::face:
      return topology.boundaryFace[n] != 0;
    case Element::cell:
      break;
  }
  const auto faces = lattice.cells[n];
  return std::ranges::any_of(faces, [&](Id face) { return topology.boundaryFace[face] != 0; });
}

// Depth of a triangle along a ray (Möller & Trumbore).
std::optional<double> depthOf(const PickRay& ray, const std::array<glm::dvec3, 3>& t) {
  const glm::dvec3 a = t[1] - t[0], b = t[2] - t[0], p = glm::cross(ray.direction, b);
  const double det = glm::dot(a, p);
  if (det == 0) return std::nullopt;
  const glm::dvec3 away = ray.origin - t[0], q = glm::cross(away, a);
  const double u = glm::dot(away, p) / det, v = glm::dot(ray.direction, q) / det;
  const double depth = glm::dot(b, q) / det;
  if (u < 0 || v < 0 || u + v > 1 || depth <= 0) return std::nullopt;
  return depth;
}

std::optional<double> faceDepth(const Lattice& lattice, const PickRay& ray, Id face) {
  const auto loop = lattice.faces[face];
  const glm::dvec3 middle = meanOf(lattice, loop);
  for (std::size_t n = 0; n < loop.size(); ++n) {
    const auto depth = depthOf(
        ray, {middle, lattice.points[loop[n]], lattice.points[loop[(n + 1) % loop.size()]]});
    if (depth) return depth;
  }
  return std::nullopt;
}

// Depth at which a ray passes a piece of line within reach.
std::optional<double> segmentDepth(const PickRay& ray, const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 side = b - a, away = ray.origin - a;
  const double dd = glm::dot(ray.direction, ray.direction), ds = glm::dot(ray.direction, side);
  const double ss = glm::dot(side, side), da = glm::dot(ray.direction, away);
  const double det = dd * ss - ds * ds;
  double u = det > 1e-12 * dd * ss ? (dd * glm::dot(side, away) - ds * da) / det : 0;
  u = std::clamp(u, 0.0, 1.0);
  const double depth = glm::dot(a + u * side - ray.origin, ray.direction) / dd;
  if (depth <= 0) return std::nullopt;
  const glm::dvec3 miss = ray.origin + depth * ray.direction - (a + u * side);
  if (glm::length(miss) > ray.reach * depth * std::sqrt(dd)) return std::nullopt;
  return depth;
}

std::optional<double> depthOfElement(const Lattice& lattice, const Topology& topology,
                                     Element element, const PickRay& ray, Id n) {
  const auto& points = lattice.points;
  if (element == Element::point) return segmentDepth(ray, points[n], points[n]);
  if (element == Element::edge) {
    return segmentDepth(ray, points[topology.edges[n][0]], points[topology.edges[n][1]]);
  }
  if (element == Element::face) return faceDepth(lattice, ray, n);
  std::optional<double> first;
  for (const Id face : lattice.cells[n]) {
    const auto depth = faceDepth(lattice, ray, face);
    if (depth && (!first || *depth < *first)) first = depth;
  }
  return first;
}

}  // namespace

glm::dvec3 middleOf(const Lattice& lattice, const Topology& topology, Element element, Id n) {
  switch (element) {
    case Element::point:
      return lattice.points[n];
    case Element::edge:
      return meanOf(lattice, topology.edges[n]);
    case Element::face:
      return meanOf(lattice, lattice.faces[n]);
    case Element::cell:
      break;
  }
  return meanOf(lattice, topology.cellPoints[n]);
}

Id nearest(const Lattice& lattice, const Topology& topology, Element element,
           const glm::dvec3& place, PickFrom from) {
  Id best = kNoId;
  double least = 0;
  for (Id n = 0; n < countOf(lattice, topology, element); ++n) {
    if (from == PickFrom::boundary && !onBoundary(lattice, topology, element, n)) continue;
    const double distance = glm::distance(middleOf(lattice, topology, element, n), place);
    if (best == kNoId || distance < least) best = n, least = distance;
  }
  return best;
}

std::vector<Picked> pickAlong(const Lattice& lattice, const Topology& topology, Element element,
                              const PickRay& ray) {
  std::vector<Picked> found;
  for (Id n = 0; n < countOf(lattice, topology, element); ++n)
    if (const auto depth = depthOfElement(lattice, topology, element, ray, n))
      found.push_back({n, *depth});
  std::ranges::stable_sort(found, {}, &Picked::depth);
  return found;
}

}  // namespace bozzetto
