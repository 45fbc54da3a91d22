// Pulling by the automaton, which the paper leaves for the future (Takai §4): grips carry whole
// cells away, and what is missing behind them is shared out as too much is: a cell that lacks takes
// from the others of its block, and those inside the clay lack in turn, until the surface gives.
#pragma once
#include "clay/layer.hpp"

namespace bozzetto::clay {

class Pulling {
 public:
  /// Moves what grips hold by whole cells along the axes, as far as their tools have moved.
  void drag(Work& work);
  /// Margolus sweeps over the blocks with cells that lack.
  void share(Work& work);

 private:
  void prepare(const Region& region);
  void shift(Work& work, std::size_t tool, int way);
  bool shareBlock(Work& work, std::size_t first);
  void lack(std::size_t cell, float wanted);
  bool lacks(const Region& region, std::size_t cell) const;
  bool inside(const Region& region, std::size_t cell) const;
  bool gives(const Region& region, std::size_t cell) const;

  KeyBox box_;
  Cells<float> wanted_;  // what a cell that lacks had; 0 elsewhere
  std::vector<std::uint32_t> lacking_, blocks_, moved_;
  std::vector<glm::dvec3> way_;  // of each tool, not yet gone
};

}  // namespace bozzetto::clay
