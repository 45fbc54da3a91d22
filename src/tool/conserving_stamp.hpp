// The conserving stamp (algorithms.md §1): what the tool presses out of its way rises round it.
#pragma once
#include "bozzetto/tool/dab.hpp"
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
    float value, shape;  // shape: density per unit of height
    Attributes attributes;
  };
  using Block = CornerBlock<Side>;

  void look(double widening, bool press);
  void lookAt(const Potential& depth, const LocalFrame& frame, Key block, bool press);
  void pressBlock(Key block, const float* depth);
  float rimShape(double depth) const;
  MassUnits gain(double height) const;
  MassUnits room() const { return gain(kHighest); }
  double heightFor(MassUnits mass) const;
  MassUnits raise(double height, MassUnits mass);
  void write(Key block, int corner, float value, Attributes attributes);

  static constexpr double kHighest = 1e4;
  Edit<Block>* edit_;
  const Dab* dab_;
  double widening_ = 1;
  std::vector<Riser> risers_;
  std::vector<Key> touched_;
  MassUnits pressed_ = 0;
  std::int64_t visited_ = 0, computed_ = 0, dirty_ = 0;
};

extern template class ConservingStamp<1>;
extern template class ConservingStamp<8>;

}  // namespace bozzetto
