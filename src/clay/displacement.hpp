// The first layer's means: kept from step to step so that nothing is allocated.
#pragma once
#include "clay/carrying.hpp"
#include "clay/layer.hpp"
#include "clay/pseudo_distance.hpp"

namespace bozzetto::clay {

class Displacement : public Layer {
 public:
  /// Carries what is free; else leaves in the region's `wish` how far each cell wants to move.
  void run(Work& work) override;
  /// That a push carried a piece along, whole.
  std::string remark() const override;

 private:
  void findCosts(Work& work);
  void findDistances(Work& work);
  float between(std::size_t pair, std::uint32_t piece) const;
  void findLead(Work& work, std::size_t tool, Cells<float>& weight);
  void smooth(Work& work, Cells<float>& weight, Cells<float>& spare);
  void findFollowing(Work& work);
  void addWish(Work& work, std::size_t tool, const Cells<float>& weight);

  Pieces pieces_;
  Carrying carrying_;
  bool pushedWhole_ = false;            // in this stroke
  std::vector<PseudoDistance> path_;    // of each moving tool, then of the static ones
  std::vector<Cells<float>> distance_;  // likewise
  std::vector<std::vector<Contact>> contacts_;
  std::size_t size_ = 0;
};

}  // namespace bozzetto::clay
