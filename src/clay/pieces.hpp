// Connected pieces of clay: runs of cells along k, joined by union-find over 6-neighbours.
#pragma once
#include "clay/region.hpp"

namespace bozzetto::clay {

class Pieces {
 public:
  struct Run {
    std::size_t base;
    std::int32_t count;
    std::uint32_t root;  ///< the first run of the piece
  };

  /// Pieces of cells with at least `threshold`.
  void find(const Region& region, float threshold);
  const std::vector<Run>& runs() const { return runs_; }
  /// The root of the piece at a cell that has at least the threshold and is no rim.
  std::uint32_t pieceAt(std::size_t cell) const { return runs_[label_[cell]].root; }

 private:
  void listRuns(const Region& region, float threshold);
  void join(std::uint32_t a, std::uint32_t b);
  std::uint32_t rootOf(std::uint32_t run);

  std::vector<Run> runs_;
  Cells<std::uint32_t> label_;
  std::size_t size_ = 0;
};

}  // namespace bozzetto::clay
