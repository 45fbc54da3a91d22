#include "clay/diffusion.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "clay/covered.hpp"
#include "clay/line_of_cells.hpp"

namespace bozzetto::clay {
namespace {

constexpr int kFairing = 2, kLastFairing = 4;  // passes
constexpr int kFairingInterval = 4;            // steps
constexpr int kSpreadings = 8;                 // rounds until what found no room walks on

float roomAt(const Region& region, std::size_t cell) {
  if (region.hold[cell] == kFixed) return 0;
  return (1 - region.cover[cell]) - region.value[cell];
}

float floored(float x) { return std::floor(x / kQuantum) * kQuantum; }

// The tool, or the support, that a cell is in; null where none is.
const PlacedTool* pushedBy(const Work& work, std::size_t cell) {
  const Key key = work.region.key(cell);
  auto first = &work.moving, second = &work.supports;
  if (work.region.owner[cell] == kStatic) std::swap(first, second);
  const bool isAlone = first->size() == 1 && second->empty();
  for (const auto* tools : {first, second})
    for (const PlacedTool& tool : *tools)
      if (tool.role != Role::grip && (isAlone || tool.cover(key) > 0)) return &tool;
  return nullptr;
}

// Outwards of what the cell is in; where the normal has no part along an axis, a little away from
// the tool's middle, so that walks that turn there go to both sides.
glm::dvec3 normalAt(const Work& work, std::size_t cell) {
  const PlacedTool* tool = pushedBy(work, cell);
  if (tool == nullptr) return {0, 1, 0};
  const Key key = work.region.key(cell), local = key - tool->solid->cell;
  glm::dvec3 normal = tool->normal(key);
  for (const Axis axis : kAxes)
    if (std::abs(normal[index(axis)]) < 1e-9) normal[index(axis)] = local[axis] < 0 ? -1e-9 : 1e-9;
  return normal;
}

// −1 … 1, another for each cell; the same sixteen cells on.
double swingOf(Key key) {
  const auto low = [](std::int32_t n) { return static_cast<std::uint32_t>(n & 15); };
  std::uint32_t x = low(key.i) << 8 | low(key.j) << 4 | low(key.k);
  x = (x ^ x >> 5) * 0x9e3779b1u;
  x = (x ^ x >> 15) * 0x85ebca6bu;
  return static_cast<double>(x >> 16) / 32768 - 1;
}

constexpr double kSwing = 0.5;  // to either side, of the way
constexpr double kFine = 1024;  // parts that the slope of a line is told in

// Away from the middle of the tool, across an axis, as the normal of an ellipsoid in its box; on
// its middle line anywhere.
Key wayAside(const Work& work, std::size_t cell, Axis across) {
  const PlacedTool* tool = pushedBy(work, cell);
  Key way{};
  if (tool == nullptr) return way;
  const Key key = work.region.key(cell);
  double aside[3] = {}, most = 0;
  for (const Axis axis : kAxes) {
    if (axis == across) continue;
    const double half = 0.5 * (tool->box.high[axis] - tool->box.low[axis]);
    const double middle = tool->box.low[axis] + half;
    aside[index(axis)] = (key[axis] - middle) / (half * half);
    most = std::max(most, std::abs(aside[index(axis)]));
  }
  const double swing = swingOf(key);
  if (most == 0) {
    most = 1;
    aside[index(next(across))] = 1 - 2 * std::abs(swing);
    aside[index(next(next(across)))] =
        (swing < 0 ? 2 : -2) * std::min(std::abs(swing), 1 - std::abs(swing));
  }
  // A little to either side, or cells of one line would all come out at one place.
  const Axis first = next(across), second = next(first);
  const double turned[2] = {aside[index(first)] - kSwing * swing * aside[index(second)],
                            aside[index(second)] + kSwing * swing * aside[index(first)]};
  way[first] = static_cast<std::int32_t>(std::lround(kFine * turned[0] / most));
  way[second] = static_cast<std::int32_t>(std::lround(kFine * turned[1] / most));
  return way;
}

constexpr double kLeastRadius = 4;

int longestWalk(const Settings& settings, double radius) {
  return static_cast<int>(std::ceil(settings.walk * std::max(radius, kLeastRadius)));
}

// Nothing closed between: a sheet of two cells is enough to part them.
bool opensOn(const Region& region, Key from, Key to) {
  const Key way = to - from;
  const int count = std::max({std::abs(way.i), std::abs(way.j), std::abs(way.k)});
  for (int n = 1; n < count; ++n) {
    const auto at = [&](std::int32_t whole) {
      return static_cast<std::int32_t>(std::lround(double(whole) * n / count));
    };
    if (isClosed(region, region.index(from + Key{at(way.i), at(way.j), at(way.k)}))) return false;
  }
  return true;
}

bool touchesDense(const Region& region, std::size_t cell) {
  for (const std::ptrdiff_t step : region.neighbours())
    if (region.value[cell + step] >= 0.5f) return true;
  return false;
}

}  // namespace

double diffusionReach(const Settings& settings, double radius) {
  return longestWalk(settings, radius) + settings.viscosity + 1;
}

float spreadAt(float u, const std::array<double, 2>& control) {
  if (control == kUniform) return 1;
  // Solve x(t) = 2t(1 − t)·cx + t² = u for t.
  const double cx = control[0], a = 1 - 2 * cx, b = 2 * cx;
  const double root = std::sqrt(std::max(0.0, b * b + 4 * a * u));
  const double t = b + root > 0 ? 2 * u / (b + root) : std::sqrt(static_cast<double>(u));
  return static_cast<float>((1 - t) * (1 - t) + 2 * t * (1 - t) * control[1]);
}

void Diffusion::prepareStencil(const Region& region, const Settings& settings) {
  stencil_.clear();
  const auto radius = static_cast<float>(settings.viscosity);
  const int reach = static_cast<int>(radius);
  for (int i = -reach; i <= reach; ++i)
    for (int j = -reach; j <= reach; ++j)
      for (int k = -reach; k <= reach; ++k) {
        const float distance = std::sqrt(static_cast<float>(i * i + j * j + k * k));
        if (distance >= radius) continue;
        const float weight = spreadAt(distance / radius, settings.profile);
        if (weight > 0)
          stencil_.push_back({i * region.strides()[0] + j * region.strides()[1] + k, weight});
      }
}

// Fills the room at the exit.
void Diffusion::leave(Region& region, const Walk& walk, float& amount) {
  const float given = std::min(amount, floored(roomAt(region, walk.at)));
  region.carry(walk.from, walk.at, given);
  moved_.note(walk.at);
  region.touch(walk.at);
  amount -= given;
}

// Over free corners near the exit that touch clay: free corners anywhere would make a haze. Each
// takes what it has room for; the rest is spread again.
void Diffusion::spread(Region& region, const Walk& walk, float& amount) {
  open_.clear();
  const Key exit = region.key(walk.at);
  for (const Neighbour& each : stencil_) {
    const auto cell = static_cast<std::ptrdiff_t>(walk.at) + each.step;
    if (cell < 0 || cell >= region.box().count()) continue;
    const Key key = region.key(static_cast<std::size_t>(cell));
    if (region.inRim(key) || roomAt(region, cell) <= 0 || !touchesDense(region, cell)) continue;
    if (!opensOn(region, exit, key)) continue;
    open_.push_back({cell, each.weight});
  }
  for (int round = 0; round < kSpreadings && amount > 0 && !open_.empty(); ++round) {
    float sum = 0;
    for (const Neighbour& each : open_) sum += each.weight;
    const float whole = amount;
    for (const Neighbour& each : open_) {
      const float wanted = std::max(kQuantum, floored(whole * each.weight / sum));
      const float given = std::min({amount, wanted, floored(roomAt(region, each.step))});
      region.carry(walk.from, each.step, given);
      moved_.note(each.step);
      region.touch(each.step);
      amount -= given;
    }
    std::erase_if(open_,
                  [&](const Neighbour& each) { return roomAt(region, each.step) < kQuantum; });
  }
}

// Along one axis until all is spent, the walk is too long, or something closed is in the way: then
// back half the way, or all would come out beside it. Out of the tool in which it starts it may go,
// and on its way outwards through that tool's other arms.
bool Diffusion::walk(Work& work, Walk& walk, float& amount) {
  Region& region = work.region;
  const double lead = walk.normal[static_cast<int>(walk.axis)];
  const std::ptrdiff_t step = lead < 0 ? -region.strides()[walk.axis] : region.strides()[walk.axis];
  const FullLines::Way way{walk.axis, lead < 0 ? -1 : 1};
  bool leaving = isClosed(region, walk.at);
  int passed = 0;
  for (int n = 0; n < longest_; ++n) {
    std::size_t next = walk.at + step;
    if (isFull(region, next)) {
      if (passed == 0 && !walk.exit) walk.exit = next;
      const int full = lines_.ahead(region, walk.at, way, longest_ - n);
      leaving = false;
      passed += full, n += full, next += full * step;
      walk.at = next - step;
      if (n == longest_) return false;
    }
    const bool closed = isClosed(region, next);
    const bool isArm = walk.turn < 3 && region.owner[next] == region.owner[walk.from] &&
                       region.owner[next] >= kMoving;
    if (closed && !((leaving || isArm) && isOfSameKind(region, next, walk.from))) {
      walk.at -= passed / 2 * step;
      return false;
    }
    leaving = closed;
    walk.at = next;
    if (!closed && passed++ == 0 && !walk.exit) walk.exit = next;
    if (roomAt(region, walk.at) < kQuantum) continue;
    if (!stencil_.empty()) spread(region, walk, amount);
    leave(region, walk, amount);
    if (amount <= 0) return true;
  }
  return false;
}

// Where walks along axes would all come out on four sides: across the axis by which it came, away
// from the tool's middle; as an axis is walked along.
bool Diffusion::walkAside(Work& work, Walk& walk, float& amount) {
  Region& region = work.region;
  Key way = wayAside(work, walk.from, kAxes[walk.axis]);
  if (way == Key{}) return false;
  if (walk.turn >= 3) way = Key{} - way;
  LineOfCells line(way, region.strides());
  bool leaving = isClosed(region, walk.at);
  passed_.clear();
  for (int n = 0; n < longest_; ++n) {
    const std::size_t next = walk.at + line.step();
    const bool closed = isClosed(region, next);
    const bool isArm = walk.turn < 3 && region.owner[next] == region.owner[walk.from] &&
                       region.owner[next] >= kMoving;
    if (closed && !((leaving || isArm) && isOfSameKind(region, next, walk.from))) {
      if (passed_.size() > 1) walk.at = passed_[passed_.size() - 1 - passed_.size() / 2];
      return false;
    }
    leaving = closed;
    walk.at = next;
    if (!closed && !walk.exit) walk.exit = next;
    if (!closed) passed_.push_back(next);
    if (roomAt(region, walk.at) < kQuantum) continue;
    if (!stencil_.empty()) spread(region, walk, amount);
    leave(region, walk, amount);
    if (amount <= 0) return true;
  }
  return false;
}

// Q splits over the axes by the normal; a walk that cannot go on turns aside and to another axis,
// and back once all have been tried, from where it left the tool (Raffin §2; algorithms.md §3). The
// paper's schemes turn to axes only.
void Diffusion::push(Work& work, std::size_t cell) {
  Region& region = work.region;
  const float excess = region.value[cell] - (1 - region.cover[cell]);
  region.touch(cell);
  const glm::dvec3 normal = normalAt(work, cell);
  const double whole = std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z);
  // Cells in turn go on along one of the two other axes, or all would come out on the same sides.
  const Key key = region.key(cell);
  const std::size_t next = 1 + ((key.i ^ key.j ^ key.k) & 1);
  const bool turnsAside = work.settings.scheme == Scheme::projected;
  float rest = excess;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double part = std::abs(normal[static_cast<int>(axis)]) / whole;
    float amount = std::min(rest, quantised(excess * static_cast<float>(part)));
    if (axis == 2) amount = rest;
    rest -= amount;
    Walk way{cell, cell, axis, normal, 0, {}};
    if (!isClosed(region, cell)) way.exit = cell;
    for (; amount > 0 && way.turn < 6; ++way.turn) {
      if (walk(work, way, amount)) break;
      if (turnsAside && way.turn % 3 == 0 && walkAside(work, way, amount)) break;
      way.axis = (way.axis + next) % 3;
      if (way.turn != 2) continue;
      if (!way.exit) break;
      way.normal = -way.normal, way.at = *way.exit;
    }
  }
}

void Diffusion::run(Work& work) {
  Region& region = work.region;
  moved_.follow(region);
  lines_.begin(region);
  double radius = 0;
  for (const PlacedTool& tool : work.moving) radius = std::max(radius, tool.radius);
  longest_ = longestWalk(work.settings, radius);
  prepareStencil(region, work.settings);
  overlapped_.clear();
  forCrowded(region, [&](std::uint32_t cell) {
    if (region.hold[cell] != kFixed) overlapped_.push_back(cell);
  });
  std::sort(overlapped_.begin(), overlapped_.end());
  overlapped_.erase(std::unique(overlapped_.begin(), overlapped_.end()), overlapped_.end());
  for (const std::uint32_t cell : overlapped_) push(work, cell);
  if (work.step % kFairingInterval == kFairingInterval - 1) fairing_.run(work, moved_, kFairing);
}

void Diffusion::finish(Work& work) {
  moved_.follow(work.region);
  fairing_.run(work, moved_, kLastFairing);
}

}  // namespace bozzetto::clay
