// One step of clay: tools are painted, layers run in their order, what was wished is carried out.
#pragma once
#include "clay/layer.hpp"
#include "clay/tidying.hpp"

namespace bozzetto::clay {

class Stepper {
 public:
  explicit Stepper(const Settings& settings);
  /// The region's static tools are painted already.
  void step(Work& work);
  /// For a region loaded in the middle of a step.
  void paint(Region& region, const std::vector<PlacedTool>& moving);
  /// After the last.
  void finish(Work& work);
  /// Before a region is left for another in the middle of a stroke.
  void leave(Work& work);
  /// What layers have to say then; may be empty.
  std::string remark() const;
  /// For a region just loaded.
  void begin(Region& region, const std::vector<PlacedTool>& supports);

 private:
  std::vector<std::unique_ptr<Layer>> layers_;
  CoverPainter painter_;
  CrumbEater crumbs_;
  bool banded_;    // some layer asks for the band
  bool travels_;   // matter, as far as tools reach
  bool crumbles_;  // and no layer eats what crumbs that leaves
};

}  // namespace bozzetto::clay
