#include "bozzetto/clay/stroke.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "bozzetto/grid/key_box.hpp"
#include "bozzetto/tool/relative.hpp"
#include "clay/diffusion.hpp"
#include "clay/exchange.hpp"
#include "clay/fade.hpp"
#include "clay/paint_moved.hpp"
#include "clay/pose_path.hpp"
#include "clay/reach.hpp"
#include "clay/stepper.hpp"
#include "clay/supports.hpp"

namespace bozzetto::clay {
namespace {

constexpr double kStepCells = 0.5;       // clay.md §3.0
constexpr double kWalkingStep = 1;       // of tools whose matter walks out at once (Raffin)
constexpr double kFluid = 0.1;           // less stiffness than this leads nobody far
constexpr std::size_t kMostImages = 64;  // tools that move at once
constexpr double kFluidReach = 1.5;      // × radius
constexpr double kFadeReach = 1;         // × radius: the outer part of that
constexpr double kSweepReach = 24;       // cells: tiles beside the tool and their neighbours
constexpr std::int64_t kMostRegion = std::int64_t{1} << 31;   // cells are counted in 32 bits
constexpr std::int64_t kMostWidened = std::int64_t{1} << 24;  // of these, for travelling matter
constexpr std::int32_t kSlack = 1;  // tiles a tool may move before its region does

bool within(const KeyBox& box, const KeyBox& outer) {
  return outer.contains(box.low) && outer.contains(box.high);
}

// Where both regions are: the pressure, for a warm start, and what cells wish for.
void keepWork(const Region& from, Region& to) {
  to.wished = from.wished;
  for (const Row& row : from.rows())
    for (std::int32_t n = 0; to.wished && n < row.count; ++n) {
      const Key key = from.box().low + Key{row.i, row.j, row.k + n};
      for (std::size_t axis = 0; to.inner().contains(key) && axis < 3; ++axis)
        to.wish[axis][to.index(key)] = from.wish[axis][row.base + n];
    }
  for (const Row& row : from.denseRows())
    for (std::int32_t n = 0; n < row.count; ++n) {
      const Key key = from.box().low + Key{row.i, row.j, row.k + n};
      if (!to.inner().contains(key)) continue;
      const std::size_t cell = to.index(key);
      to.pressure[cell] =
          from.pressure[row.base + n] * (to.freedom(cell) / from.freedom(row.base + n));
    }
}

// Swelling is the automaton's, and the surface is tidied, whatever layers run when clay is pushed.
Setup setupFor(const Doing& doing, Setup setup) {
  if (doing.role == Role::swell) setup.settings.layers = {LayerKind::automaton, LayerKind::tension};
  return setup;
}

void requireSound(const Stroke& stroke) {
  if (stroke.points.empty()) throw Error("stroke: no points found, at least one expected");
  if (!stroke.rotations.empty() && stroke.rotations.size() != stroke.points.size()) {
    throw Error("stroke: " + std::to_string(stroke.rotations.size()) + " rotations found, " +
                std::to_string(stroke.points.size()) + " expected, one a point");
  }
  bozzetto::requireValid(stroke.symmetry);
  bozzetto::requireValid(stroke.placement);
}

std::string noticesOf(std::string notices, const std::vector<Support>& supports, double spacing) {
  for (const Support& support : supports) {
    const std::string thin = noticeOf(support, spacing);
    if (thin.empty() || notices.find(thin) != std::string::npos) continue;
    notices += (notices.empty() ? "" : "; ") + thin;
  }
  return notices;
}

std::vector<glm::dvec3> copiesOf(const Placement& placement, double spacing) {
  std::vector<glm::dvec3> copies;
  for (int i = 0; i < placement.copies[0]; ++i)
    for (int j = 0; j < placement.copies[1]; ++j)
      for (int k = 0; k < placement.copies[2]; ++k)
        copies.push_back(glm::dvec3(i, j, k) * placement.copyStep / spacing);
  return copies;
}

}  // namespace

template <int Side>
struct ClayStroke<Side>::State {
  Edit<CornerBlock<Side>>* edit;
  Setup setup;
  double spacing;
  Doing doing;
  float iso;
  ToolShape tool;  // radii in cells
  std::string notice;
  Key origin;
  std::vector<glm::dmat3> images;
  std::vector<glm::dvec3> copies;  // where they stand, from the tool, in cells
  bool sizes = false;              // pressure does
  glm::dvec3 centre{0};
  std::optional<PosePath> path;
  std::vector<PlacedTool> supports;
  Stepper stepper;
  std::optional<Region> region;
  PaintMoved paint;
  double stiffest;  // anywhere
  bool whole = true, touching = false;
  std::vector<KeyRun> changed;  // by what was stored between two calls of store()

  State(Edit<CornerBlock<Side>>& into, const FieldScale& scale, const Doing& what,
        const Setup& given)
      : edit(&into),
        setup(setupFor(what, given)),
        spacing(scale.spacing),
        doing(what),
        iso(scale.iso),
        supports(placeSupports(given.supports, scale.spacing)),
        stepper(setup.settings),
        paint(given.stiffness),
        stiffest(followingAt(static_cast<float>(setup.settings.stiffness), paint.most())) {}

  bool runs(LayerKind kind) const { return clay::runs(setup.settings, kind); }
  double stepCells() const { return onlyWalks(setup.settings) ? kWalkingStep : kStepCells; }

  // Nothing happens far from the tool.
  bool fluid() const {
    if (doing.role == Role::swell) return true;
    return stiffest <= kFluid || !runs(LayerKind::displacement);
  }

  double radius() const { return std::max({tool.radii.x, tool.radii.y, tool.radii.z}); }

  // How far round the tool fluid clay gives way; the automaton asks for more where it goes further.
  std::int32_t margin() const {
    const bool sweeps = doing.role == Role::swell || runs(LayerKind::automaton);
    double cells = kFluidReach * radius();
    if (sweeps && !runs(LayerKind::conservation)) cells = kSweepReach;
    if (sweeps) cells = std::max(cells, kSweepReach);
    if (runs(LayerKind::diffusion)) {
      const double farthest = diffusionReach(setup.settings, radius());
      const bool others = sweeps || runs(LayerKind::conservation);
      cells = others ? std::max(cells, farthest) : farthest;
    }
    return static_cast<std::int32_t>(cells);
  }

  DabPose dabPose(const Pose& pose) const {
    return {origin, pose.position, glm::mat3_cast(pose.rotation * tool.rotation),
            tool.radii * std::max(pose.size, leastSize())};
  }

  // Smaller than two cells no tool is.
  double leastSize() const {
    const double smallest = std::min({tool.radii.x, tool.radii.y, tool.radii.z});
    return std::min(1.0, kSmallestToolCells / smallest);
  }

  // Checks it, and that the tool has room there.
  Pose poseOf(const StrokePoint& point, const glm::dquat& rotation) const {
    cellOf(point.position, spacing, "stroke point");
    if (!(point.pressure >= 0 && point.pressure <= 1)) {
      throw Error("stroke pressure: " + std::to_string(point.pressure) +
                  " found, a number in 0…1 expected");
    }
    const Pose pose{relativeTo(origin, point.position, spacing), normalisedRotation(rotation),
                    sizes ? point.pressure : 1};
    dabBox(dabPose(pose));
    return pose;
  }

  void requireCount(const PosePath& way) const {
    if (way.count() < static_cast<double>(kMostDabs)) return;
    throw Error("stroke: " + std::to_string(way.count()) +
                " steps found, at most 10 million expected");
  }

  // A freeform tool stands on its pivot.
  PlacedTool placeAt(DabPose pose) const {
    const glm::dvec3 stand = pose.position;
    PlacedTool placed = placeSolid(pose);
    const Key cell = placed.solid->cell - pose.origin;
    placed.stand = stand - glm::dvec3(cell.i, cell.j, cell.k);
    return placed;
  }

  PlacedTool placeSolid(DabPose pose) const {
    if (tool.shape != Shape::freeform) return place(makeSolid(tool.shape, pose), pose, doing.role);
    const Sculpture& sculpture = *tool.sculpture;
    pose.position -= pose.orientation * (sculpture.pivot() * pose.radii / sculpture.halfExtents());
    PlacedTool placed = place(makeSolid(tool.sculpture, pose), pose, doing.role);
    if (doing.role == Role::swell) placed.core = coreDepth(sculpture, pose);
    return placed;
  }

  // The tool and its images after `now` steps, moved since `before`. A grip leads what it holds by
  // its strength, as a share of its own way.
  std::vector<PlacedTool> toolsAt(double before, double now) const {
    const Pose from = path->at(before), to = path->at(now);
    const Pose led =
        doing.role == Role::grip ? path->at(before + doing.strength * (now - before)) : to;
    const glm::dmat3 turn =
        glm::mat3_cast(led.rotation) * glm::transpose(glm::mat3_cast(from.rotation));
    std::vector<PlacedTool> tools;
    for (const glm::dvec3& copy : copies)
      for (const glm::dmat3& image : images) {
        DabPose pose = dabPose(to);
        pose.position = centre + image * (to.position + copy - centre);
        pose.orientation = image * pose.orientation;
        const glm::dmat3 turned = image * turn * glm::transpose(image);
        const glm::dvec3 start = centre + image * (from.position + copy - centre);
        const glm::dvec3 end = centre + image * (led.position + copy - centre);
        const Motion motion{turned - glm::dmat3(1), end - turned * start};
        PlacedTool placed = placeAt(pose);
        placed.motion = motion;
        placed.strength = static_cast<float>(doing.strength);
        tools.push_back(std::move(placed));
      }
    return tools;
  }

  static KeyBox boxOf(const std::vector<PlacedTool>& tools) {
    KeyBox box;
    for (const PlacedTool& each : tools) box = united(box, each.box);
    return box;
  }

  Reach reachOf(const KeyBox& tools) const {
    if (!fluid()) return connectedClay<Side>(*edit, tools);
    if (!anyClay<Side>(*edit, tools)) return {};
    return {grown(tools, margin()), false};
  }

  // Loads another region where the tool, or the clay, leaves the one there is.
  void lookAround(const std::vector<PlacedTool>& tools) {
    const KeyBox box = boxOf(tools);
    KeyBox needed = box;
    if (fluid()) needed = grown(box, margin());
    if (region && within(needed, region->inner()) && !(whole && region->reachesRim())) return;
    if (region) atRest([&](Work& work) { stepper.leave(work); });
    load(reachOf(box), needed);
  }

  // The tool has met clay: another piece than before, perhaps, that goes on beyond the region.
  void lookAgain(const std::vector<PlacedTool>& tools) {
    if (fluid() || !whole) return;
    storeRegion();
    const Reach reach = reachOf(boxOf(tools));
    if (!within(reach.box, region->inner())) load(reach, boxOf(tools));
  }

  void storeRegion() {
    if (!region) return;
    const std::vector<Key> tiles = region->takeChanged();
    const auto keys = clay::store<Side>(*region, tiles, *edit);
    paint.store(*region, tiles);
    changed.insert(changed.end(), keys.begin(), keys.end());
  }

  void load(const Reach& reach, const KeyBox& needed) {
    storeRegion();
    if (reach.box.empty()) {
      region.reset();
      return;
    }
    whole = reach.whole;
    const KeyBox box = tileBox(united(reach.box, needed), 1 + (whole ? kRoom : kSlack));
    if (box.count() > kMostRegion) {
      throw Error("stroke: " + std::to_string(box.count()) +
                  " cells found round the tool, at most 2 billion expected where clay is moved");
    }
    Region next(box);
    clay::load<Side>(next, *edit);
    paint.load<Side>(next, *edit);
    if (!whole && next.clayInRim && !onlyWalks(setup.settings))
      fadeTowardsRim(next, kFadeReach * radius());
    stepper.begin(next, supports);
    if (region) keepWork(*region, next);
    region.emplace(std::move(next));
  }

  bool touches(const std::vector<PlacedTool>& tools) const {
    return std::any_of(tools.begin(), tools.end(),
                       [&](const PlacedTool& each) { return touchesClay(*region, each); });
  }

  // Only what a tool moves since contact counts (Dewaele §3.1): where in the step that began.
  double contactIn(double before, double now) const {
    for (int n = 0; n < 4; ++n) {
      const double middle = 0.5 * (before + now);
      (touches(toolsAt(middle, middle)) ? now : before) = middle;
    }
    return before;
  }

  StepReport step(std::int64_t n) {
    StepReport report;
    const auto now = static_cast<double>(n);
    double before = std::max(0.0, now - 1);
    std::vector<PlacedTool> tools = toolsAt(before, now);
    lookAround(tools);
    if (!region) return report;
    const bool touched = touching;
    touching = path->at(now).size > 0 && touches(tools);
    if (!touching) return report;
    if (!touched) lookAgain(tools);
    if (!touched && n > 0) tools = toolsAt(contactIn(before, now), now);
    run(tools, n, report);
    return report;
  }

  void run(const std::vector<PlacedTool>& tools, std::int64_t n, StepReport& report) {
    Work work{*region, tools, supports, origin, setup.settings, iso, n, report};
    if (!whole) work.widen = [&](const KeyBox& box) { return widen(box, tools); };
    stepper.step(work);
  }

  // Between steps, without the moving tools.
  template <class Callback>
  void atRest(const Callback& callback) {
    const std::vector<PlacedTool> none;
    StepReport report;
    Work work{*region, none, supports, origin, setup.settings, iso, 0, report};
    callback(work);
  }

  // In the middle of a step. Too much is left as it is: clay beyond counts as held.
  bool widen(const KeyBox& box, const std::vector<PlacedTool>& tools) {
    if (within(box, region->inner())) return false;
    const Reach wider{united(region->inner(), box), false};
    if (wider.box.count() > kMostWidened) return false;
    region->refreshRows();
    load(wider, wider.box);
    stepper.paint(*region, tools);
    return true;
  }
};

template <int Side>
ClayStroke<Side>::ClayStroke(Edit<CornerBlock<Side>>& edit, const FieldScale& scale,
                             const ToolShape& tool, const Doing& doing, const Stroke& stroke,
                             const Setup& setup) {
  clay::requireValid(setup.settings);
  for (const Support& support : setup.supports) clay::requireValid(support);
  requireSound(stroke);
  state_ = std::make_unique<State>(edit, scale, doing, setup);
  const FittedTool fitted = fitTool(tool, scale.spacing);
  state_->tool = fitted.shape;
  state_->tool.radii /= scale.spacing;
  state_->notice = noticesOf(fitted.notice, setup.supports, scale.spacing);
  state_->origin = cellOf(stroke.points.front().position, scale.spacing, "stroke point");
  state_->images = imagesOf(stroke.symmetry);
  state_->copies = copiesOf(stroke.placement, scale.spacing);
  state_->sizes = stroke.pressure.size;
  const std::size_t images = state_->images.size() * state_->copies.size();
  if (images > kMostImages) {
    throw Error("stroke: " + std::to_string(images) +
                " images and copies found, at most 64 expected where clay is moved");
  }
  state_->centre = relativeTo(state_->origin, stroke.symmetry.centre, scale.spacing);
  std::vector<Pose> poses;
  for (std::size_t n = 0; n < stroke.points.size(); ++n)
    poses.push_back(state_->poseOf(
        stroke.points[n], stroke.rotations.empty() ? glm::dquat(1, 0, 0, 0) : stroke.rotations[n]));
  state_->path.emplace(poses, glm::length(state_->tool.radii), state_->stepCells());
  state_->requireCount(*state_->path);
}

template <int Side>
void ClayStroke<Side>::extend(std::span<const StrokePoint> points) {
  PosePath longer = *state_->path;
  for (const StrokePoint& point : points)
    longer.append(state_->poseOf(point, longer.lastRotation()));
  state_->requireCount(longer);
  state_->path = longer;
}

template <int Side>
ClayStroke<Side>::~ClayStroke() = default;

template <int Side>
std::int64_t ClayStroke<Side>::stepCount() const {
  return static_cast<std::int64_t>(state_->path->count()) + 1;
}

template <int Side>
std::int64_t ClayStroke<Side>::sureSteps() const {
  return static_cast<std::int64_t>(state_->path->sure()) + 1;
}

template <int Side>
const std::string& ClayStroke<Side>::notice() const {
  return state_->notice;
}

template <int Side>
StepReport ClayStroke<Side>::step(std::int64_t n) {
  return state_->step(n);
}

template <int Side>
void ClayStroke<Side>::finish() {
  state_->notice.clear();
  if (!state_->region) return;
  state_->atRest([&](Work& work) { state_->stepper.finish(work); });
  state_->notice = state_->stepper.remark();
}

template <int Side>
std::vector<KeyRun> ClayStroke<Side>::store() {
  state_->storeRegion();
  std::vector<KeyRun> changed;
  changed.swap(state_->changed);
  std::sort(changed.begin(), changed.end(),
            [](const KeyRun& a, const KeyRun& b) { return a.key < b.key; });
  const auto same = [](const KeyRun& a, const KeyRun& b) { return a.key == b.key; };
  changed.erase(std::unique(changed.begin(), changed.end(), same), changed.end());
  return changed;
}

template <int Side>
Stiffness ClayStroke<Side>::stiffness() {
  return state_->paint.now();
}

template class ClayStroke<1>;
template class ClayStroke<8>;

}  // namespace bozzetto::clay
