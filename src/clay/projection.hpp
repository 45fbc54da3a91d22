// Makes a wished displacement one that keeps volumes: subtracts the gradient of a pressure that
// solves a Poisson equation in the clay (clay.md §3.3). What is too much in a cell is a source,
// what is too little inside a sink, so that clay follows instead of thinning.
#pragma once
#include "clay/layer.hpp"

namespace bozzetto::clay {

struct SolverOptions {
  int sweeps = 12;         ///< red-black, over-relaxed by 1.85, from the last step's pressure
  int settlingSweeps = 3;  ///< without over-relaxation: no checkerboard remains
};

/// From region.wish (0 when nothing is wished) to region.face.
void project(Work& work, const SolverOptions& options = {});

/// From region.wish to region.face as it is.
void followWish(Work& work);

/// What a cell is to the solver: closed where held or mostly in a tool.
void findTypes(Work& work);

}  // namespace bozzetto::clay
