// From lists of blocks to a changed tree: what dabs and fills share.
#pragma once
#include "bozzetto/tool/dab.hpp"

namespace bozzetto {

enum class WriteTo { own, fresh };

template <int Side>
const CornerBlock<Side>& emptyBlock() {
  static const auto* const block = new CornerBlock<Side>();
  return *block;
}

/// The old corners and room for the new ones: in the edit's own block where it has one and may,
/// else in a fresh one. From several threads, each with its own work.
template <int Side>
BlockView viewOf(const Edit<CornerBlock<Side>>& edit, BlockWork<Side>& work, WriteTo to) {
  const CornerBlock<Side>& old = work.old == nullptr ? emptyBlock<Side>() : *work.old;
  work.settled = old.settled || work.old == nullptr;
  CornerBlock<Side>* out = to == WriteTo::own ? edit.own(work.old) : nullptr;
  if (out == nullptr) {
    work.fresh = edit.own(Ref<CornerBlock<Side>>(new CornerBlock<Side>(ForOverwrite{})));
    out = work.fresh.get();
  }
  BlockView view{CornerBlock<Side>::kCount,
                 old.value.data(),
                 old.attributes.data(),
                 out->value.data(),
                 out->attributes.data(),
                 nullptr,
                 nullptr};
  view.oneColour = work.settled && (old.oneColour || work.old == nullptr);
  view.only = old.only;
  view.low = old.low;
  return view;
}

template <int Side>
void describe(CornerBlock<Side>& block, const Outcome& outcome) {
  block.low = outcome.low;
  block.high = outcome.high;
  block.oneColour = outcome.oneColour;
  block.only = outcome.only;
  block.settled = outcome.settled;
}

/// Puts what changed into the tree, adds it to the report and empties the list. Blocks that end
/// uniform become the interned ones at once: their memory serves the next dab.
template <int Side>
void writeAll(Edit<CornerBlock<Side>>& edit, std::vector<BlockWork<Side>>& list,
              DabReport& report) {
  using Block = CornerBlock<Side>;
  typename Edit<Block>::Place place(edit);
  for (BlockWork<Side>& work : list) {
    const Outcome& outcome = work.outcome;
    report.dropped += outcome.dropped;
    Block* now = work.fresh ? work.fresh.get() : edit.own(work.old);
    if (outcome.dirty == 0) {
      if (!work.fresh && now != nullptr) now->settled = work.settled;
      continue;
    }
    report.dirty += outcome.dirty;
    report.changed.push_back({work.key, outcome.corners});
    describe(*now, outcome);
    if (outcome.high <= 0) {
      edit.replace(work.key, nullptr, place);
    } else if (Side > 1 && outcome.uniform) {
      edit.replace(work.key, Block::uniform(now->value[0], now->attributes[0]), place);
    } else if (work.fresh) {
      edit.replace(work.key, work.fresh, place);
    }
  }
  list.clear();
}

}  // namespace bozzetto
