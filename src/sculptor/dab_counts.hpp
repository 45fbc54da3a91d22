// From dabs to the report of their operation.
#pragma once
#include "bozzetto/sculptor/report.hpp"
#include "bozzetto/tool/dab.hpp"

namespace bozzetto {

inline void addCounts(const DabReport& dab, double spacing, OperationReport& report) {
  report.visited += dab.visited;
  report.computed += dab.computed;
  report.dirty += dab.dirty;
  report.massDropped +=
      static_cast<double>(dab.dropped) * kMassUnit * (spacing * spacing * spacing);
}

}  // namespace bozzetto
