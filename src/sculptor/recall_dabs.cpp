#include "sculptor/recall_dabs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace bozzetto {
namespace {

ActionOptions adding(double strength) {
  ActionOptions action;
  action.kind = ActionKind::add;
  action.strength = strength;
  return action;
}

struct Corner {
  float value;
  Attributes attributes;
};

// Each channel moved from `from` towards `to`.
Attributes mixed(Attributes from, Attributes to, float weight) {
  Attributes result = 0;
  for (int shift = 0; shift < 32; shift += 8) {
    const auto a = static_cast<float>(from >> shift & 255);
    const auto b = static_cast<float>(to >> shift & 255);
    result |= static_cast<Attributes>(std::lround(a + weight * (b - a))) << shift;
  }
  return result;
}

Corner recalled(Corner now, Corner past, float weight) {
  weight *= 1 - static_cast<float>(holdOf(now.attributes)) / 255;
  if (weight >= 1) return past;
  if (weight <= 0) return now;
  const float own = (1 - weight) * now.value, brought = weight * past.value;
  const float value = own + brought;
  if (value <= 0) return {0, 0};
  return {value, mixed(now.attributes, past.attributes, brought / value)};
}

template <int Side>
Corner cornerOf(const CornerBlock<Side>* block, int n) {
  return block == nullptr ? Corner{0, 0} : Corner{block->value[n], block->attributes[n]};
}

}  // namespace

template <int Side>
RecallDabs<Side>::RecallDabs(Workbench<Side>& bench, Edit<Block>& edit, const Stroke& stroke)
    : edit_(&edit),
      weights_(roomEdit_, bench.field().scale, bench.hand.tool(bench.field().scale.spacing),
               adding(bench.hand.action.strength), stroke) {
  Field<Side> past = bench.history().fieldAt(*bench.hand.recall, bench.field());
  if (past.scale.spacing != bench.field().scale.spacing) {
    throw Error(fmt::format("recall: step {} has spacing {}, {} expected", *bench.hand.recall,
                            past.scale.spacing, bench.field().scale.spacing));
  }
  past_ = std::move(past.tree);
}

template <int Side>
DabReport RecallDabs<Side>::dab(std::int64_t n) {
  DabReport report = weights_.dab(n);
  std::set<Key> keys;
  for (const ChangedRun& run : std::exchange(report.changed, {})) {
    for (std::int32_t k = 0; k < run.length; ++k) keys.insert(run.key + Key{0, 0, k});
  }
  report.dirty = 0;
  for (const Key key : keys) {
    const Block* weight = room_.find(key);
    const int dirty = weight == nullptr ? 0 : blend(key, *weight);
    report.dirty += dirty;
    if (dirty > 0) report.changed.emplace_back(KeyRun{key, 1});
  }
  roomEdit_.rollback();
  return report;
}

// How many corners changed.
template <int Side>
int RecallDabs<Side>::blend(Key key, const Block& weight) {
  const Block* past = past_.find(key);
  const Block* now = edit_->read(key);
  if (past == now) return 0;
  Ref<Block> made = edit_->fresh();
  int dirty = 0;
  for (int n = 0; n < Block::kCount; ++n) {
    const Corner old = cornerOf<Side>(now, n);
    const Corner corner = recalled(old, cornerOf<Side>(past, n), weight.value[n]);
    made->value[n] = corner.value;
    made->attributes[n] = corner.attributes;
    dirty += corner.value != old.value || corner.attributes != old.attributes ? 1 : 0;
  }
  if (dirty == 0) return 0;
  made->updateRange();
  edit_->replace({key, 1}, made->high > 0 ? made : nullptr);
  return dirty;
}

template class RecallDabs<1>;
template class RecallDabs<8>;

}  // namespace bozzetto
