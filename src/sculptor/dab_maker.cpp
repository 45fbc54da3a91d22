#include "sculptor/dab_maker.hpp"

#include "bozzetto/clay/idle.hpp"
#include "bozzetto/clay/stroke.hpp"
#include "sculptor/recall_dabs.hpp"

namespace bozzetto {
namespace {

template <int Side>
class BrushDabs final : public DabMaker<Side> {
 public:
  BrushDabs(Workbench<Side>& bench, Edit<CornerBlock<Side>>& edit, const Stroke& stroke)
      : runner_(edit, bench.field().scale, bench.hand.tool(bench.field().scale.spacing),
                bench.hand.action, stroke) {}
  void extend(std::span<const StrokePoint> points) override { runner_.extend(points); }
  std::int64_t dabCount() const override { return runner_.dabCount(); }
  std::int64_t sureDabs() const override { return runner_.sureDabs(); }
  std::string notice() const override { return runner_.placementNotice(); }
  DabReport dab(std::int64_t n) override { return runner_.dab(n); }
  std::vector<ChangedRun> finish() override { return {}; }

 private:
  StrokeRunner<Side> runner_;
};

// A brush on what painted stiffness is kept in, where there is clay.
template <int Side>
class StiffenDabs final : public DabMaker<Side> {
 public:
  StiffenDabs(const Workbench<Side>& bench, const Stroke& stroke)
      : bench_(bench),
        now_(bench.clay.stiffness),
        painted_(now_.any() ? *now_.painted : Clay{}),
        edit_(painted_.tree),
        runner_(edit_, faced(bench, stroke), bench.hand.tool(bench.field().scale.spacing),
                bench.hand.action, stroke) {
    painted_.scale = bench.field().scale;
  }
  void extend(std::span<const StrokePoint> points) override { runner_.extend(points); }
  std::int64_t dabCount() const override { return runner_.dabCount(); }
  std::int64_t sureDabs() const override { return runner_.sureDabs(); }
  std::string notice() const override { return runner_.placementNotice(); }
  DabReport dab(std::int64_t n) override {
    DabReport report = runner_.dab(n);
    const std::vector<KeyRun> blocks(report.changed.begin(), report.changed.end());
    clay::keepOnClay<Side>(edit_, blocks, bench_.field().tree);
    report.changed.clear();  // the clay is as it was
    return report;
  }
  std::vector<ChangedRun> finish() override { return {}; }
  std::optional<clay::Stiffness> stiffness() override {
    if (!edit_.commit().changes.empty()) now_ = clay::stiffnessOf(painted_);
    return now_;
  }

 private:
  static Clay faced(const Workbench<Side>& bench, const Stroke& stroke) {
    if (stroke.placement.toNormal) return withSide<8>(bench.field());
    return {{}, bench.field().scale};
  }

  const Workbench<Side>& bench_;
  clay::Stiffness now_;
  Clay painted_;
  Edit<CornerBlock<8>> edit_;
  StrokeRunner<8> runner_;
};

template <int Side>
class ClayDabs final : public DabMaker<Side> {
 public:
  ClayDabs(Workbench<Side>& bench, Edit<CornerBlock<Side>>& edit, const Stroke& stroke)
      : shows_(bench.shows()),
        idle_(clay::idleIn(stroke, clayRoleOf(bench.hand.action.kind), bench.clay.settings)),
        stroke_(edit, bench.field().scale, bench.hand.tool(bench.field().scale.spacing),
                {clayRoleOf(bench.hand.action.kind), bench.hand.action.strength}, stroke,
                bench.clay) {}
  void extend(std::span<const StrokePoint> points) override { stroke_.extend(points); }
  std::int64_t dabCount() const override { return stroke_.stepCount(); }
  std::int64_t sureDabs() const override { return stroke_.sureSteps(); }
  std::string notice() const override {
    const std::string& met = stroke_.notice();
    if (finished_) return met;
    return idle_ + (idle_.empty() || met.empty() ? "" : "; ") + met;
  }
  DabReport dab(std::int64_t n) override {
    DabReport report;
    const clay::StepReport step = stroke_.step(n);
    report.visited = report.computed = step.cells;
    report.dirty = step.clayCells;
    if (shows_) report.changed = stored();
    return report;
  }
  std::vector<ChangedRun> finish() override {
    stroke_.finish();
    finished_ = true;
    return stored();
  }
  std::optional<clay::Stiffness> stiffness() override { return stroke_.stiffness(); }

 private:
  std::vector<ChangedRun> stored() {
    const std::vector<KeyRun> runs = stroke_.store();
    return {runs.begin(), runs.end()};
  }

  bool shows_, finished_ = false;
  std::string idle_;
  clay::ClayStroke<Side> stroke_;
};

}  // namespace

clay::Role clayRoleOf(ActionKind kind) {
  return kind == ActionKind::grip    ? clay::Role::grip
         : kind == ActionKind::swell ? clay::Role::swell
                                     : clay::Role::push;
}

template <int Side>
std::unique_ptr<DabMaker<Side>> makeDabMaker(Workbench<Side>& bench, Edit<CornerBlock<Side>>& edit,
                                             const Stroke& stroke) {
  if (bench.hand.recall) return std::make_unique<RecallDabs<Side>>(bench, edit, stroke);
  if (stiffens(bench.hand.action.kind)) return std::make_unique<StiffenDabs<Side>>(bench, stroke);
  if (movesClay(bench.hand.action.kind))
    return std::make_unique<ClayDabs<Side>>(bench, edit, stroke);
  return std::make_unique<BrushDabs<Side>>(bench, edit, stroke);
}

template std::unique_ptr<DabMaker<1>> makeDabMaker(Workbench<1>&, Edit<CornerBlock<1>>&,
                                                   const Stroke&);
template std::unique_ptr<DabMaker<8>> makeDabMaker(Workbench<8>&, Edit<CornerBlock<8>>&,
                                                   const Stroke&);

}  // namespace bozzetto
