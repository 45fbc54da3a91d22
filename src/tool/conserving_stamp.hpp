// The conserving stamp (algorithms.md §1): what the tool presses out of its way rises round it.
#pragma once
#include "bozzetto/tool/dab.hpp"
#include "tool/lowpass.hpp"
#include "tool/mass_units.hpp"
#include "tool/stamp_depth.hpp"

namespace bozzetto {

/// One dab. The bulge's height is found so that what rises weighs what goes; where the clay is full
/// before that, the rim widens step by step to four reference radii, then rises cell by cell. What
/// finds no clay to rise from is missing, and the ledger shows it. O(corners of the widest rim).
template <int Side>
class ConservingStamp {
 public:
  struct Dab {
    DabPose pose;
    const ToolShape& tool;  ///< in cells
    StampOptions options;
    double iso;
    double strength;
  };
  ConservingStamp(Edit<CornerBlock<Side>>& edit, const Dab& dab) : edit_(&edit), dab_(&dab) {}
  void apply(DabReport& report);

 private:
  struct Riser {  // a corner that may rise
    Key at, block;
    int corner;
    Attributes attributes;
  };
  using Block = CornerBlock<Side>;
  using Depths = std::array<float, Block::kCount>;

  void reachOut(double widening);
  template <class Visit>
  void forBlocks(Visit&& visit);
  bool hasWall() const;
  void press();
  void pressBlock(Key block, const Depths& depth);
  void look(double widening);
  void lookAt(Key block, const StampCurve& curve);
  const Depths& depthsOf(Key block);
  Neighbourhood<Side> around(Key block) const;
  std::size_t placeOf(Key block) const;
  std::size_t tableSize() const { return placeOf(blocks_.high + Key{1, 1, 1}) + 1; }
  MassUnits gain(double height) const;
  MassUnits room() const { return gain(kHighest); }
  double heightFor(MassUnits mass) const;
  MassUnits raise(double height, MassUnits mass);
  MassUnits raiseRest(double height, MassUnits rest);
  void write(Key block, int corner, float value, Attributes attributes);

  static constexpr double kHighest = 1e4;
  Edit<Block>* edit_;
  const Dab* dab_;

  // As far as the rim reaches: its blocks and, once asked for, how deep their corners lie. Both
  // tables have a rim of one.
  double widening_ = 0;
  std::unique_ptr<Potential> depth_;
  LocalFrame frame_;
  KeyBox blocks_;
  std::vector<std::unique_ptr<Depths>> depths_;
  std::vector<const Block*> table_;

  std::vector<Riser> risers_;
  std::vector<float> value_, shape_;  // of the risers; shape: density per unit of height
  MassUnits held_ = 0;                // by the risers
  std::vector<Key> touched_;
  Block* open_ = nullptr;  // the last of them
  MassUnits pressed_ = 0;
  std::int64_t visited_ = 0, computed_ = 0, dirty_ = 0;
};

extern template class ConservingStamp<1>;
extern template class ConservingStamp<8>;

}  // namespace bozzetto
