// The conserving stamp (algorithms.md §1): what the tool presses out of its way rises round it.
#pragma once
#include "bozzetto/tool/dab.hpp"
#include "tool/lowpass.hpp"
#include "tool/mass_units.hpp"
#include "tool/stamp_depth.hpp"
#include "tool/swept.hpp"

namespace bozzetto {

/// One dab. The bulge's height is found so that what rises weighs what goes; where it would be
/// higher than was asked for, the rim widens step by step to four reference radii. The clay climbs
/// as under plain stamps (action_stamp), layer upon layer. What finds no clay to rise from is
/// missing, and the ledger shows it. O(corners of the widest rim).
template <int Side>
class ConservingStamp {
 public:
  struct Dab {
    DabPose pose;
    const ToolShape& tool;  ///< in cells
    StampOptions options;
    double iso;
    double strength;
    Swept<Side>* swept;  ///< by dabs before; this one adds itself; null: rises there too
  };
  ConservingStamp(Edit<CornerBlock<Side>>& edit, const Dab& dab) : edit_(&edit), dab_(&dab) {}
  void apply(DabReport& report);

 private:
  struct Riser {  // a corner that may rise
    Key block;
    int corner;
    Attributes attributes;
  };
  using Block = CornerBlock<Side>;
  struct Place {  // a block as the tool lies in it
    alignas(64) std::array<float, Block::kCount> depth, body, curve, most;
    bool rises = false;  // somewhere
  };

  void reachOut(double widening);
  template <class Visit>
  void forBlocks(Visit&& visit);
  bool hasWall() const;
  void press();
  void pressBlock(Key block, const Place& place);
  void sweep();
  void look(double widening);
  void lookAt(Key block, const Place& place);
  const Place& placeOf(Key block);
  const SweptBlock<Side>& sweptOf(Key block) const;
  void bend(Key block, Place& place) const;
  Key firstOf(Key block) const;
  Neighbourhood<Side> around(Key block) const;
  std::size_t indexOf(Key block) const;
  std::size_t tableSize() const { return indexOf(blocks_.high + Key{1, 1, 1}) + 1; }
  MassUnits gain(float way) const;
  double tooHigh(MassUnits mass) const;
  double widened(double widening, MassUnits mass) const;
  float wayFor(MassUnits mass) const;
  MassUnits raise(float way, MassUnits mass);
  MassUnits raiseRest(float way, MassUnits rest);
  void write(Key block, int corner, float value, Attributes attributes);

  Edit<Block>* edit_;
  const Dab* dab_;

  // As far as the rim reaches: its blocks and, once asked for, how the tool lies in them. Both
  // tables have a rim of one.
  double widening_ = 0;
  std::unique_ptr<Potential> depth_;
  LocalFrame frame_;
  KeyBox blocks_;
  std::vector<std::unique_ptr<Place>> places_;
  std::vector<const Block*> table_;

  std::vector<Riser> risers_;
  std::vector<float> value_, climb_, most_;  // of the risers; climb: density per cell of way
  MassUnits held_ = 0;                       // by the risers
  std::vector<Key> touched_;
  Block* open_ = nullptr;  // the last of them
  MassUnits pressed_ = 0;
  std::int64_t visited_ = 0, computed_ = 0, dirty_ = 0;
};

extern template class ConservingStamp<1>;
extern template class ConservingStamp<8>;

}  // namespace bozzetto
