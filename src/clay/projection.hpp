// Makes a wished displacement one that keeps volumes: subtracts the gradient of a pressure that
// solves a Poisson equation in the clay (clay.md §3.3). What is too much in a cell is a source,
// what is too little inside a sink, so that clay follows instead of thinning.
#pragma once
#include "clay/layer.hpp"
#include "clay/pressure_grid.hpp"

namespace bozzetto::clay {

/// From the last step's pressure: cycles of sweeps and corrections on coarser cells.
struct SolverOptions {
  int cycles = 1;
  int before = 3, after = 3;  ///< red-black sweeps; the last without over-relaxation
};

class Projection {
 public:
  /// From region.wish (0 when nothing is wished) to region.face.
  void run(Work& work, const SolverOptions& options = {});

 private:
  PressureGrid grid_;
};

/// Before a layer adds to region.wish: 0 unless another has wished already.
void beginWish(Region& region);

/// From region.wish to region.face as it is.
void followWish(Work& work);

/// What a cell is to the solver: closed where held or mostly in a tool.
void findTypes(Work& work);

}  // namespace bozzetto::clay
