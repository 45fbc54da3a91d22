// Clay that grips stretch draws its surface together, as wet clay does: it is faired there, step by
// step. Without it what is rounded off in a step grows, as air grows fingers into a surface that
// recedes, into pits of some cells. What moves as a whole, or bends, keeps its relief.
#pragma once
#include "clay/fairing.hpp"

namespace bozzetto::clay {

class Drawing {
 public:
  /// After matter was carried by region.face. What a grip holds keeps its form.
  void run(Work& work);

 private:
  MovedCells strained_;
  Fairing fairing_;
};

}  // namespace bozzetto::clay
