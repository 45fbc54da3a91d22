// What operations on solids share.
#pragma once
#include <fmt/format.h>

#include "bozzetto/solid/solid.hpp"
#include "sculptor/run.hpp"

namespace bozzetto {

/// The solid there is. Throws Error when there is none.
template <int Side>
const Solid& solidOf(const Workbench<Side>& bench, const char* op) {
  if (bench.solid() == nullptr)
    throw Error(fmt::format("{}: found no solid, expected one ('solid' or 'wrap' makes it)", op));
  return *bench.solid();
}

inline Solid newSolid(NamedLattice block) {
  Solid solid;
  solid.control = std::move(block.lattice);
  solid.names = std::move(block.names);
  return solid;
}

// A step that changes the solid and no clay.
template <int Side>
void keepSolid(Workbench<Side>& bench, std::optional<Solid> solid, OperationReport& report) {
  bench.setSolid(solid ? std::make_shared<const Solid>(std::move(*solid)) : nullptr);
  Edit<CornerBlock<Side>> edit(bench.tree());
  bench.keep(edit, report);
}

}  // namespace bozzetto
