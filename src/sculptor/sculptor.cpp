#include "bozzetto/sculptor/sculptor.hpp"

#include "sculptor/run.hpp"

namespace bozzetto {

template <int Side>
OperationReport BasicSculptor<Side>::apply(const Operation& operation, Progress& progress) {
  OperationReport report;
  report.op = nameOf(operation);
  report.massBefore = bench_.mass();
  std::visit([&](const auto& each) { run(each, bench_, Telling{report, progress}); }, operation);
  report.massAfter = bench_.mass();
  return report;
}

template class BasicSculptor<1>;
template class BasicSculptor<8>;

}  // namespace bozzetto
