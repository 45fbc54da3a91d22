// Keeps clay compact (Dewaele §3.3; clay.md §3.5, 3.6): no dust that a sparse tree would have to
// store for ever, no crumbs of a few cells.
#pragma once
#include "clay/layer.hpp"
#include "clay/pieces.hpp"

namespace bozzetto::clay {

/// Cells of less than 0.05 that have no dense neighbour join their densest one.
void sweepDust(Work& work);

/// What becomes of a crumb's matter: excess that a layer will press out, or it goes to the nearest
/// room beside clay at once.
enum class Eaten { isPressedOut, findsRoom };

class CrumbEater {
 public:
  /// Pieces of fewer than `settings.crumb` cells become excess of the nearest dense cell; where
  /// clay parts, so do shreds: fewer cells than that squared, nowhere a cube of 3³.
  void run(Work& work, Eaten eaten);

 private:
  void eat(Work& work, std::uint32_t piece);
  void settle(Work& work, std::size_t target);
  bool isCrumb(const Work& work, std::uint32_t piece) const;
  bool isThin(const Work& work, std::uint32_t piece) const;
  bool isWhole(const Region& region, std::uint32_t piece) const;
  std::size_t nearestClay(const Work& work, std::uint32_t piece);

  Pieces pieces_;
  std::vector<std::int32_t> cellsOf_;
  std::vector<std::size_t> eaters_;
  std::vector<std::uint32_t> crumb_, ring_, next_;
};

}  // namespace bozzetto::clay
