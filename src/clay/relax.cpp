// The layers without a tool: clay that settles.
#include <algorithm>

#include "bozzetto/clay/stroke.hpp"
#include "clay/paint_moved.hpp"
#include "clay/reach.hpp"
#include "clay/stepper.hpp"
#include "clay/supports.hpp"

namespace bozzetto::clay {
namespace {

constexpr int kMostSteps = 10'000'000;
constexpr int kStillSteps = 8;  // then parities and intervals of all layers have come round

// Tells whether the clay of a region, and what it carries, is as it was a step before.
class Stillness {
 public:
  explicit Stillness(const Region& region) {
    for (std::size_t n = 0; n <= region.carried.size(); ++n)
      before_.emplace_back(static_cast<std::size_t>(region.box().count()));
  }
  bool isStill(const Region& region) {
    bool still = isSame(region, region.value, before_.back());
    for (std::size_t n = 0; n < region.carried.size(); ++n)
      still = isSame(region, region.carried[n], before_[n]) && still;
    return still;
  }

 private:
  static bool isSame(const Region& region, const Cells<float>& now, Cells<float>& before) {
    bool same = true;
    for (const Row& row : region.rows()) {
      const float* cells = &now[row.base];
      same = same && std::equal(cells, cells + row.count, &before[row.base]);
      if (!same) std::copy_n(cells, row.count, &before[row.base]);
    }
    return same;
  }

  std::vector<Cells<float>> before_;
};

void settle(Region& region, const Setup& setup, const FieldScale& scale, int steps) {
  Stepper stepper(setup.settings);
  const auto supports = placeSupports(setup.supports, scale.spacing);
  stepper.begin(region, supports);
  const std::vector<PlacedTool> none;
  Stillness stillness(region);
  int still = 0;
  for (int n = 0; n < steps && still < kStillSteps; ++n) {
    StepReport report;
    Work work{region, none, supports, {}, setup.settings, scale.iso, n, report};
    stepper.step(work);
    still = stillness.isStill(region) ? still + 1 : 0;
  }
}

}  // namespace

template <int Side>
std::vector<KeyRun> relax(Edit<CornerBlock<Side>>& edit, const FieldScale& scale, Setup& setup,
                          int steps) {
  requireValid(setup.settings);
  for (const Support& support : setup.supports) requireValid(support);
  if (steps > kMostSteps) {
    throw Error("relax: " + std::to_string(steps) + " steps found, at most 10 million expected");
  }
  const Reach reach = allClay<Side>(edit);
  if (reach.box.empty()) return {};
  if (!reach.whole)
    throw Error("relax: more clay found than the working set of 16 million cells can hold");
  Region region(tileBox(reach.box, 1 + kRoom));
  load<Side>(region, edit);
  PaintMoved paint(setup.stiffness);
  paint.load<Side>(region, edit);
  settle(region, setup, scale, steps);
  const std::vector<Key> tiles = region.takeChanged();
  paint.store(region, tiles);
  setup.stiffness = paint.now();
  return store<Side>(region, tiles, edit);
}

template std::vector<KeyRun> relax(Edit<CornerBlock<1>>&, const FieldScale&, Setup&, int);
template std::vector<KeyRun> relax(Edit<CornerBlock<8>>&, const FieldScale&, Setup&, int);

}  // namespace bozzetto::clay
