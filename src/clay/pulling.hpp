// Pulling where the automaton runs, which the paper leaves for the future (Takai §4): a grip drags
// what is next to it along. Blocks that share what lacks, as they share what is too much, leave
// cracks and struts; so the surface gives by pressure, as in the projected scheme.
#pragma once
#include "clay/projection.hpp"

namespace bozzetto::clay {

class Pulling {
 public:
  /// One step: nothing without grips, or where displacement leads the clay.
  void run(Work& work);

 private:
  Projection projection_;
};

}  // namespace bozzetto::clay
