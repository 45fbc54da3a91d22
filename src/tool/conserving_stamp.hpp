// The conserving stamp (algorithms.md §1): what the tool presses out of its way rises round it.
#pragma once
#include <deque>
#include <mutex>

#include "bozzetto/tool/dab.hpp"
#include "tool/lowpass.hpp"
#include "tool/mass_units.hpp"
#include "tool/risers.hpp"
#include "tool/stamp_depth.hpp"
#include "tool/swept.hpp"

namespace bozzetto {

/// One dab. The bulge's height is found so that what rises weighs what goes; where it would be
/// higher than was asked for, the rim widens step by step to four reference radii. The clay climbs
/// as under plain stamps (action_stamp), layer upon layer. What finds no clay to rise from is
/// missing, and the ledger shows it. O(corners of the widest rim); looks at blocks in parallel.
template <int Side>
class ConservingStamp {
 public:
  struct Dab {
    DabPose pose;
    const ToolShape& tool;  ///< in cells
    StampOptions options;
    double iso;
    double strength;
    Swept<Side>* swept;   ///< by dabs before; this one adds itself; null: rises there too
    bool facing = false;  ///< the tool's contact side faces the clay: sculptures have a handle
  };
  ConservingStamp(Edit<CornerBlock<Side>>& edit, const Dab& dab);
  void apply(DabReport& report);

 private:
  using Block = CornerBlock<Side>;
  struct Place {  // a block as the rim lies in it
    alignas(64) std::array<float, Block::kCount> curve, most;
    bool rises = false;  // somewhere
  };

  void reachOut(double widening);
  void gatherTable();
  void listBlocks();
  void join(Key block);
  template <class Visit>
  void forBody(Visit&& visit);
  bool hasWall() const;
  void press();
  void pressBlock(Key block);
  void sweep();
  void look(double widening);
  void lookAt(std::size_t listed, Risers& risers);
  void addRisers(std::size_t listed, const Place& place, const float* climb, Risers& risers) const;
  Place& newPlace();
  const Place& placeOf(Key block);
  const SweptBlock<Side>& sweptOf(Key block) const;
  void bend(Key block, const float* depth, const float* body, Place& place) const;
  bool hasHandle() const { return dab_->swept != nullptr && depth_->hasHandle(); }
  void withHandle(Key block, float* body) const;
  Key firstOf(Key block) const;
  Neighbourhood<Side> around(Key block) const;
  Faces<Side> facesOf(Key block) const;
  bool reaches(Key block) const;
  Key blockOf(std::size_t riser) const { return listed_[risers_.place[riser] / Block::kCount]; }
  int cornerOf(std::size_t riser) const { return int(risers_.place[riser] % Block::kCount); }
  std::size_t indexOf(Key block) const;
  std::size_t tableSize() const { return indexOf(blocks_.high + Key{1, 1, 1}) + 1; }
  void colour();
  MassUnits gain(float way) const;
  double tooHigh(MassUnits mass) const;
  double widened(double widening, MassUnits mass) const;
  float wayFor(MassUnits mass) const;
  MassUnits raise(float way, MassUnits mass);
  MassUnits raiseRest(float way, MassUnits rest);
  void write(Key block, std::size_t corner, float value);
  void open(Key block);

  Edit<Block>* edit_;
  const Dab* dab_;

  // As far as the rim reaches: its blocks, which of them are to be looked at and, once asked for,
  // how the rim lies in them. The tables have a rim of one.
  double widening_ = 0;
  StampCurve curve_;
  std::unique_ptr<StampTool> depth_;
  LocalFrame frame_;
  KeyBox blocks_, bodyBlocks_;
  std::vector<const Place*> places_;
  std::deque<Place> made_;  // the first so many of these
  std::size_t madeCount_ = 0;
  std::mutex making_;
  std::vector<const Block*> table_;
  std::vector<Key> listed_;  // with clay in them or across a face, and room
  std::vector<std::uint8_t> isListed_;

  Risers risers_;                    // of the blocks in listed_
  std::vector<Attributes> colours_;  // of those of them that had no clay, in turn
  MassUnits held_ = 0, layer_ = 0;   // by the risers; what a whole layer gains
  std::vector<Key> touched_;
  Block* open_ = nullptr;  // the last of them
  MassUnits pressed_ = 0;
  std::int64_t visited_ = 0, computed_ = 0, dirty_ = 0;
};

extern template class ConservingStamp<1>;
extern template class ConservingStamp<8>;

}  // namespace bozzetto
