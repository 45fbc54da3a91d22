#include "solid/transfer.hpp"

#include <cmath>
#include <map>

#include "bozzetto/base/error.hpp"
#include "bozzetto/solid/refine.hpp"
#include "solid/body.hpp"

namespace bozzetto {
namespace {

using Cell = std::array<std::int64_t, 3>;

// Places of an old lattice by where they are.
class Finder {
 public:
  Finder(std::span<const glm::dvec3> places, double grain) : grain_(grain) {
    for (Id n = 0; n < places.size(); ++n) known_.try_emplace(cellOf(places[n]), n);
  }
  Id at(const glm::dvec3& place) const {
    const auto found = known_.find(cellOf(place));
    return found == known_.end() ? kNoId : found->second;
  }

 private:
  Cell cellOf(const glm::dvec3& p) const {
    return {std::llround(p.x / grain_), std::llround(p.y / grain_), std::llround(p.z / grain_)};
  }
  double grain_;
  std::map<Cell, Id> known_;
};

double grainOf(const Lattice& lattice) {
  double most = 1e-30;
  for (const auto& p : lattice.points)
    most = std::max({most, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return most * 1e-8;
}

// Both solids refined, and which refined points are the same.
struct Match {
  Lattice before, after;
  Topology topologyBefore, topologyAfter;
  std::vector<Id> points;

  Match(const Lattice& from, const Lattice& to, int levels)
      : before(refine(from, levels).lattice),
        after(refine(to, levels).lattice),
        topologyBefore(before),
        topologyAfter(after) {
    const Finder finder(before.points, grainOf(from));
    for (const auto& p : after.points) points.push_back(finder.at(p));
  }

  std::vector<double> pointValues(const std::vector<double>& old) const {
    if (old.empty()) return {};
    std::vector<double> result;
    for (const Id n : points) result.push_back(n == kNoId ? 1 : old[n]);
    return result;
  }

  std::vector<double> lengths(const std::vector<double>& old) const {
    if (old.empty()) return {};
    std::vector<double> result = lengthsOf(topologyAfter, after.points);
    for (std::size_t n = 0; n < result.size(); ++n) {
      const auto [a, b] = topologyAfter.edges[n];
      if (points[a] == kNoId || points[b] == kNoId) continue;
      const Id edge = topologyBefore.edgeBetween(points[a], points[b]);
      if (edge != kNoId) result[n] = old[edge];
    }
    return result;
  }

  // Rest angles by centre and arms.
  std::vector<double> angles(const std::vector<double>& old) const {
    if (old.empty()) return {};
    std::map<std::array<Id, 3>, double> known;
    forCorners(before, [&](std::size_t n, Id centre, PointPair arms) {
      known[{centre, arms[0], arms[1]}] = old[n];
    });
    std::vector<double> result = anglesOf(after, after.points);
    forCorners(after, [&](std::size_t n, Id centre, PointPair arms) {
      if (points[centre] == kNoId || points[arms[0]] == kNoId || points[arms[1]] == kNoId) return;
      const PointPair there = pointPair(points[arms[0]], points[arms[1]]);
      const auto found = known.find({points[centre], there[0], there[1]});
      if (found != known.end()) result[n] = found->second;
    });
    return result;
  }

  std::vector<std::uint8_t> cells(const std::vector<std::uint8_t>& old) const {
    if (old.empty()) return {};
    std::vector<glm::dvec3> middles;
    for (Id n = 0; n < before.cells.size(); ++n)
      middles.push_back(meanOf(before, topologyBefore.cellPoints[n]));
    const Finder finder(middles, grainOf(before) * 10);
    std::vector<std::uint8_t> result;
    for (Id n = 0; n < after.cells.size(); ++n) {
      const Id there = finder.at(meanOf(after, topologyAfter.cellPoints[n]));
      result.push_back(there == kNoId ? 0 : old[there]);
    }
    return result;
  }

 private:
  template <class Callback>
  static void forCorners(const Lattice& lattice, Callback&& callback) {
    for (std::size_t face = 0; face < lattice.faces.size(); ++face) {
      const auto loop = lattice.faces[face];
      for (std::size_t c = 0; c < loop.size(); ++c)
        callback(lattice.faces.startOf(face) + c, loop[c],
                 pointPair(loop[(c + 1) % loop.size()], loop[(c + loop.size() - 1) % loop.size()]));
    }
  }
};

template <class T>
std::vector<T> carried(const std::vector<T>& old, std::span<const Id> oldPoints, T usual) {
  if (old.empty()) return {};
  std::vector<T> result;
  for (const Id n : oldPoints) result.push_back(n == kNoId ? usual : old[n]);
  return result;
}

}  // namespace

Solid withControl(const Solid& old, Lattice control, std::span<const Id> oldPoints,
                  const char* tool) {
  if (old.isWrap())
    throw Error(std::string(tool) + ": found a wrap, expected a solid: a wrap keeps its cells");
  Compacted tidy = compacted(control);
  if (const auto fault = validate(tidy.lattice))
    throw Error(std::string(tool) + ": found no solid (" + *fault + "), expected one");
  std::vector<Id> from;
  for (const Id n : tidy.oldPoints) from.push_back(oldPoints[n]);

  const SolidMatter& matter = old.matter;
  Solid result;
  result.settings = old.settings;
  result.names = carried(old.names, from, Solid::kNoName);
  result.matter.fixed = carried<std::uint8_t>(matter.fixed, from, 0);
  result.matter.velocity = carried(matter.velocity, from, glm::dvec3(0));
  const bool any = !matter.mass.empty() || !matter.hardness.empty() || !matter.lengths.empty() ||
                   !matter.angles.empty() || !matter.trimmed.empty();
  if (any) {
    const Match match(old.control, tidy.lattice, old.settings.levels);
    result.matter.mass = match.pointValues(matter.mass);
    result.matter.hardness = match.pointValues(matter.hardness);
    result.matter.lengths = match.lengths(matter.lengths);
    result.matter.angles = match.angles(matter.angles);
    result.matter.trimmed = match.cells(matter.trimmed);
  }
  result.control = std::move(tidy.lattice);
  return result;
}

}  // namespace bozzetto
