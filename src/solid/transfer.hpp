// What a solid was made of, brought over to its changed lattice.
#pragma once
#include "bozzetto/solid/solid.hpp"

namespace bozzetto {

/// `old` with another control lattice. `oldPoints[n]` is what control point n was, kNoId when new.
/// Mass, hardness, rest lengths and angles and trims go to what lies where they were; elsewhere all
/// is as usual and the present shape is the rest. Throws Error when the lattice is no valid solid,
/// with `tool` in front.
Solid withControl(const Solid& old, Lattice control, std::span<const Id> oldPoints,
                  const char* tool);

}  // namespace bozzetto
