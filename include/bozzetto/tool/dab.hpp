// One application of a tool (Ferley §3.2): the walk through its box, block by block.
#pragma once
#include <cstdint>
#include <map>
#include <vector>

#include "bozzetto/field/field.hpp"
#include "bozzetto/tool/action.hpp"
#include "bozzetto/tool/potential.hpp"

namespace bozzetto {

/// The paper's counts, and what the dab touched.
struct DabReport {
  std::int64_t visited = 0;         ///< corners in the grid-aligned box of the tool's local box
  std::int64_t computed = 0;        ///< of these, corners in the local box too
  std::int64_t dirty = 0;           ///< corners that changed
  MassUnits dropped = 0;            ///< mass let go by smoothing thin support
  std::vector<ChangedRun> changed;  ///< blocks and their dirty corners; may repeat between dabs

  void add(const DabReport& other);
};

template <int Side>
class SweptBlock;

/// A block on its way from old to new.
template <int Side>
struct BlockWork {
  Key key;
  const CornerBlock<Side>* old = nullptr;  ///< null where there is none
  Ref<CornerBlock<Side>> fresh;            ///< the new one, where it is not written in place
  Outcome outcome;
  bool settled = false;               ///< `old` was
  SweptBlock<Side>* swept = nullptr;  ///< where dabs of the stroke before have been, if any
};

/// Corners of the grid-aligned box. Throws Error when it leaves the workspace.
KeyBox dabBox(const DabPose& pose);

/// Applies tool and action once and adds to `report`. Touches only blocks that change; in parallel
/// where there are enough of them, with the same result. O(corners in the box).
template <int Side>
class DabWalker {
 public:
  using Block = CornerBlock<Side>;
  explicit DabWalker(Edit<Block>& edit) : edit_(&edit) {}

  struct Dab {
    DabPose pose;
    const Potential* potential;
    const Action* action;
    float strength;
    std::map<Key, SweptBlock<Side>>* swept = nullptr;  ///< for actions that ask for bodies
  };
  void apply(const Dab& dab, DabReport& report);

 private:
  struct Walk;

  void listColumn(const Walk& walk, std::int32_t bi, std::int32_t bj);
  void listPiece(const Walk& walk, KeyRun piece, const Block* block);
  SweptBlock<Side>* sweptAt(const Walk& walk, Key block);
  void sweep(const Walk& walk, const BlockWork<Side>& work) const;
  void gatherNeighbourhood(const Walk& walk);
  void compute(const Walk& walk);
  void compute(const Walk& walk, BlockWork<Side>& work) const;

  Edit<Block>* edit_;
  std::vector<BlockWork<Side>> work_;
  const void* left_ = nullptr;  // empty space or the interned block that the action leaves alone
  std::vector<const Block*> neighbourhood_;  // of the dab's blocks and a rim of one, for lowpass
};

extern template class DabWalker<1>;
extern template class DabWalker<8>;

}  // namespace bozzetto
