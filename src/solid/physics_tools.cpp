// Tools that change what a solid is made of, and tools that pull it (§6.2, §6.4).
#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>

#include "bozzetto/base/error.hpp"
#include "bozzetto/solid/refine.hpp"
#include "bozzetto/solid/tools.hpp"
#include "solid/body.hpp"

namespace bozzetto {
namespace {

constexpr double kLeast = 1e-3, kMost = 1e3;

// 1 in the middle, 0 at the rim, smooth at both.
double falloff(double distance, double radius) {
  const double t = 1 - distance * distance / (radius * radius);
  return t > 0 ? t * t : 0;
}

void requireRadius(double radius) {
  if (radius > 0 && std::isfinite(radius)) return;
  throw Error("solid: found a radius of " + std::to_string(radius) + ", expected one above 0");
}

Id nearestPlace(std::span<const glm::dvec3> places, const glm::dvec3& to) {
  Id best = 0;
  for (Id n = 0; n < places.size(); ++n)
    if (glm::distance(places[n], to) < glm::distance(places[best], to)) best = n;
  return best;
}

Solid run(const Solid& solid, std::span<const Rope> ropes, int steps, RunReport* report) {
  if (steps < 0 || steps > 100000)
    throw Error("solid: found " + std::to_string(steps) + " steps, expected 0 to 100000");
  Simulation simulation(solid);
  RunReport total;
  const auto start = std::chrono::steady_clock::now();
  for (; total.steps < steps; ++total.steps) {
    const StepReport step = simulation.step(ropes);
    total.rolledBack += step.rolledBack ? 1 : 0;
    total.iterations += double(step.iterations) / steps;
  }
  const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - start;
  if (steps > 0) total.msStep = passed.count() / steps;
  total.energy = simulation.energy();
  if (report != nullptr) *report = total;
  return simulation.solid();
}

}  // namespace

Solid painted(const Solid& solid, Matter matter, const glm::dvec3& at, double radius,
              double factor) {
  requireRadius(radius);
  if (!(factor >= kLeast && factor <= kMost))
    throw Error("solid: found a factor of " + std::to_string(factor) + ", expected 0.001 to 1000");
  Solid result = solid;
  const Lattice refined = refine(solid.control, solid.settings.levels).lattice;
  auto& list = matter == Matter::mass ? result.matter.mass : result.matter.hardness;
  if (list.empty()) list.assign(refined.points.size(), 1);
  for (std::size_t n = 0; n < list.size(); ++n) {
    const double weight = falloff(glm::distance(refined.points[n], at), radius);
    list[n] = std::clamp(list[n] * (1 + weight * (factor - 1)), kLeast, kMost);
  }
  return result;
}

Solid inflated(const Solid& solid, const glm::dvec3& at, double radius, double amount) {
  requireRadius(radius);
  if (!(amount > -1 && amount <= 4))
    throw Error("inflate: found an amount of " + std::to_string(amount) + ", expected -1 to 4");
  Solid result = solid;
  const Lattice refined = refine(solid.control, solid.settings.levels).lattice;
  const Topology topology(refined);
  if (result.matter.lengths.empty()) result.matter.lengths = lengthsOf(topology, refined.points);
  if (result.matter.angles.empty()) result.matter.angles = anglesOf(refined, refined.points);
  for (std::size_t n = 0; n < topology.edges.size(); ++n) {
    const double distance = glm::distance(meanOf(refined, topology.edges[n]), at);
    result.matter.lengths[n] *= 1 + amount * falloff(distance, radius);
  }
  return result;
}

Solid trimmed(const Solid& solid, const glm::dvec3& at, double radius, TakesPart part) {
  requireRadius(radius);
  Solid result = solid;
  const Lattice refined = refine(solid.control, solid.settings.levels).lattice;
  const Topology topology(refined);
  auto& list = result.matter.trimmed;
  if (list.empty()) list.assign(refined.cells.size(), 0);
  for (Id n = 0; n < list.size(); ++n)
    if (glm::distance(meanOf(refined, topology.cellPoints[n]), at) <= radius)
      list[n] = part == TakesPart::no ? 1 : 0;
  if (std::ranges::count(list, 0) == 0)
    throw Error("trim: found no cell that would take part, expected one");
  return result;
}

Solid windowed(const Solid& solid, const std::optional<std::array<glm::dvec3, 2>>& box) {
  Solid result = solid;
  result.matter.fixed.clear();
  if (!box) return result;
  const auto& [low, high] = *box;
  for (const auto& p : solid.control.points) {
    const bool inside = p.x >= low.x && p.y >= low.y && p.z >= low.z && p.x <= high.x &&
                        p.y <= high.y && p.z <= high.z;
    result.matter.fixed.push_back(inside ? 0 : 1);
  }
  if (std::ranges::count(result.matter.fixed, 0) == 0)
    throw Error("window: found no control point inside, expected one");
  return result;
}

Solid atRest(const Solid& solid) {
  Solid result = solid;
  result.matter.lengths.clear();
  result.matter.angles.clear();
  result.matter.velocity.clear();
  return result;
}

Solid pulled(const Solid& solid, std::span<const Pull> pulls, double strength, int steps,
             RunReport* report) {
  const Lattice refined = refine(solid.control, solid.settings.levels).lattice;
  std::vector<Rope> ropes;
  for (const Pull& pull : pulls)
    ropes.push_back({nearestPlace(refined.points, pull.at), pull.to, strength});
  return run(solid, ropes, steps, report);
}

// (c₋ + 4c + c₊)/6 = place, ends natural: c₀ = place₀, cₙ = placeₙ. Thomas' algorithm.
std::vector<glm::dvec3> splineThrough(std::span<const glm::dvec3> places) {
  const std::size_t count = places.size();
  std::vector<glm::dvec3> controls(places.begin(), places.end());
  if (count < 3) return controls;
  std::vector<double> upper(count, 0);
  for (std::size_t n = 1; n + 1 < count; ++n) {
    const double pivot = 4 - upper[n - 1];
    upper[n] = 1 / pivot;
    controls[n] = (6.0 * places[n] - controls[n - 1]) / pivot;
  }
  for (std::size_t n = count - 1; n-- > 1;) controls[n] -= upper[n] * controls[n + 1];
  return controls;
}

std::vector<glm::dvec3> splinePlaces(std::span<const glm::dvec3> controls) {
  std::vector<glm::dvec3> places(controls.begin(), controls.end());
  for (std::size_t n = 1; n + 1 < controls.size(); ++n)
    places[n] = (controls[n - 1] + 4.0 * controls[n] + controls[n + 1]) / 6.0;
  return places;
}

// Natural ends are ends whose controls go on in a straight line.
std::vector<glm::dvec3> splineCurve(std::span<const glm::dvec3> controls, int cuts) {
  if (controls.size() < 2) return {controls.begin(), controls.end()};
  const std::size_t last = controls.size() - 1;
  const auto control = [&](std::size_t n) {  // numbered from one before the first
    if (n == 0) return 2.0 * controls[0] - controls[1];
    if (n == last + 2) return 2.0 * controls[last] - controls[last - 1];
    return controls[n - 1];
  };
  std::vector<glm::dvec3> curve;
  for (std::size_t piece = 0; piece < last; ++piece) {
    for (int n = piece == 0 ? 0 : 1; n <= cuts; ++n) {
      const double t = double(n) / cuts, s = 1 - t;
      curve.push_back(
          (s * s * s * control(piece) + (3 * t * t * t - 6 * t * t + 4) * control(piece + 1) +
           (3 * s * s * s - 6 * s * s + 4) * control(piece + 2) + t * t * t * control(piece + 3)) /
          6.0);
    }
  }
  return curve;
}

Solid splined(const Solid& solid, std::span<const glm::dvec3> points,
              std::span<const SplineDrag> drags, int steps, RunReport* report) {
  const Lattice refined = refine(solid.control, solid.settings.levels).lattice;
  std::vector<Rope> ropes;
  std::vector<glm::dvec3> places;
  for (const auto& point : points) {
    const Id n = nearestPlace(refined.points, point);
    ropes.push_back({n, refined.points[n], solid.settings.ropeStrength});
    places.push_back(refined.points[n]);
  }
  std::vector<glm::dvec3> controls = splineThrough(places);
  for (const SplineDrag& drag : drags) {
    if (drag.control >= controls.size())
      throw Error("spline: found control point " + std::to_string(drag.control) +
                  ", expected less than " + std::to_string(controls.size()));
    controls[drag.control] += drag.by;
  }
  places = splinePlaces(controls);
  for (std::size_t n = 0; n < ropes.size(); ++n) ropes[n].to = places[n];
  return run(solid, ropes, steps, report);
}

double probedStiffness(const Solid& solid, const glm::dvec3& at, double radius) {
  requireRadius(radius);
  const Body body(solid);
  const auto& points = body.refined.lattice.points;
  double sum = 0, count = 0;
  for (const NormalSpring& spring : body.springs.normal()) {
    if (glm::distance((points[spring.a] + points[spring.b]) * 0.5, at) > radius) continue;
    sum += spring.stiffness;
    count += 1;
  }
  return count > 0 ? sum / count : 0;
}

std::vector<double> tinted(const Solid& solid, Tint tint) {
  const Lattice refined = refine(solid.control, solid.settings.levels).lattice;
  std::vector<double> usual(refined.points.size(), tint == Tint::strain ? 0 : 1);
  const auto& list = tint == Tint::mass ? solid.matter.mass : solid.matter.hardness;
  if (tint != Tint::strain) return list.empty() ? usual : list;
  if (solid.matter.lengths.empty()) return usual;
  const Topology topology(refined);
  for (Id n = 0; n < usual.size(); ++n) {
    const auto edges = topology.pointEdges[n];
    for (const Id edge : edges) {
      const auto [a, b] = topology.edges[edge];
      const double rest = solid.matter.lengths[edge];
      usual[n] += std::abs(glm::distance(refined.points[a], refined.points[b]) - rest) / rest /
                  double(edges.size());
    }
  }
  return usual;
}

NamedLattice coarseBlock(const std::array<glm::dvec3, 2>& box, int cells,
                         const std::function<bool(const glm::dvec3&)>& filled) {
  if (cells < 1 || cells > 64)
    throw Error("solid: found " + std::to_string(cells) + " cells, expected 1 to 64");
  const glm::dvec3 size = box[1] - box[0];
  const double edge = std::max({size.x, size.y, size.z}) / cells;
  if (!(edge > 0)) throw Error("solid: found a box without extent, expected one with");
  BlockOptions options;
  options.edge = glm::dvec3(edge);
  options.centre = (box[0] + box[1]) / 2.0;
  for (const Axis axis : kAxes)
    options.cells[axis] = std::max(1, int(std::ceil(size[index(axis)] / edge - 1e-9)));
  const glm::dvec3 count(options.cells.i, options.cells.j, options.cells.k);
  for (std::int32_t i = 0; i < options.cells.i; ++i)
    for (std::int32_t j = 0; j < options.cells.j; ++j)
      for (std::int32_t k = 0; k < options.cells.k; ++k) {
        const glm::dvec3 middle = options.centre + (glm::dvec3(i, j, k) + 0.5 - 0.5 * count) * edge;
        if (!filled(middle)) options.removed.push_back({i, j, k});
      }
  return makeBlock(options);
}

}  // namespace bozzetto
