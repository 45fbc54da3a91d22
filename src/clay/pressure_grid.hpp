// Coarser copies of the pressure's equation, cells of 2³, 4³ and 8³ that never leave a tile: what
// sweeps over single cells would carry across a large body only cell by cell is found there (a
// V-cycle of multigrid; McAdams, Sifakis & Teran 2010 have it for liquids).
#pragma once
#include "clay/region.hpp"

namespace bozzetto::clay {

class PressureGrid {
 public:
  /// Reads region.type and region.mark2 (how many neighbours of a clay cell are air) in the dense
  /// rows and builds the coarse equations; faces to air count `skin`. Allocates when the region is
  /// another one only.
  void prepare(const Region& region, float skin = 1);
  /// Adds to region.pressure what the coarse cells know of its error. region.rhs and
  /// region.inverse are the fine equation's.
  void correct(Region& region);

 private:
  static constexpr int kLevels = 3;
  struct Level {
    std::array<std::ptrdiff_t, 3> strides{};
    Key low{};  // its first cell, in its own cells
    Cells<float> pressure, source, inverse, air;
    std::array<Cells<float>, 3> link;  // to the next cell along each axis
    std::vector<Row> rows;
  };

  void resize(const Region& region);
  void listRows(const Region& region);
  void linkFine(const Region& region);
  void linkCoarse(const Level& fine, Level& coarse);
  void finishLinks(Level& level, float airWeight);
  void restrictFine(const Region& region);
  void restrictCoarse(const Level& fine, Level& coarse);
  void solve(int level);
  static void sweep(Level& level, float relaxation);

  std::array<Level, kLevels> levels_;
  KeyBox box_;
};

}  // namespace bozzetto::clay
