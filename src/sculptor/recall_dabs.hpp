// The dabs of action recall: under the tool, the clay of a chosen state of the history comes back.
#pragma once
#include "sculptor/dab_maker.hpp"

namespace bozzetto {

/// With w the tool's potential times strength, at most 1: v ← v + w·(past − v), attributes likewise
/// weighted by density; where w is 1 the past comes back bit for bit. Hold lessens w as for every
/// action.
template <int Side>
class RecallDabs final : public DabMaker<Side> {
 public:
  /// Throws Error when the state is not in the history or had another spacing.
  RecallDabs(Workbench<Side>& bench, Edit<CornerBlock<Side>>& edit, const Stroke& stroke);

  void extend(std::span<const StrokePoint> points) override { weights_.extend(points); }
  std::int64_t dabCount() const override { return weights_.dabCount(); }
  std::int64_t sureDabs() const override { return weights_.sureDabs(); }
  std::string notice() const override { return weights_.placementNotice(); }
  DabReport dab(std::int64_t n) override;
  std::vector<ChangedRun> finish() override { return {}; }

 private:
  using Block = CornerBlock<Side>;
  int blend(Key key, const Block& weight);

  Edit<Block>* edit_;
  KeyTree<Block> past_;
  // The tool adds to empty room: what stands there after a dab is w.
  KeyTree<Block> room_;
  Edit<Block> roomEdit_{room_};
  StrokeRunner<Side> weights_;
};

extern template class RecallDabs<1>;
extern template class RecallDabs<8>;

}  // namespace bozzetto
