// What a step did to the solid, as bytes of its undo-file: good in both directions, and sure to
// fit.
#pragma once
#include "bozzetto/grid/delta.hpp"
#include "bozzetto/solid/solid_codec.hpp"

namespace bozzetto::undo {

/// No bytes where nothing changed. O(solid).
Bytes encodeSolidPart(const SolidRef& before, const SolidRef& after);

/// What `here` is after, or was before the step. Throws Error, `name` first, where `here` is not
/// what the part was made from.
SolidRef solidBeyond(const SolidRef& here, std::span<const std::byte> part, Direction direction,
                     const std::string& name);

}  // namespace bozzetto::undo
