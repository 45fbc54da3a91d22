// What a step did to what stands beside the clay, as bytes of its undo-file: good in both
// directions, and sure to fit.
#pragma once
#include "bozzetto/grid/delta.hpp"
#include "bozzetto/history/beside.hpp"
#include "bozzetto/solid/solid_codec.hpp"

namespace bozzetto::undo {

/// Parts of undo-files before version 3 are of the solid alone.
enum class BesideForm { solidAlone, whole };

/// No bytes where nothing changed. O(their bytes).
Bytes encodeBesidePart(const Beside& before, const Beside& after);

/// What `here` is after, or was before the step. Throws Error, `name` first, where the solid here
/// is not what the part was made from. Supports, ledger and paint are what the part says; where it
/// says nothing they stay.
Beside besideBeyond(const Beside& here, std::span<const std::byte> part, Direction direction,
                    BesideForm form, const std::string& name);

/// All of it, for checkpoints. No bytes for nothing.
Bytes encodeBeside(const Beside& beside);
Beside decodeBeside(std::span<const std::byte> bytes, BesideForm form, const std::string& name);

}  // namespace bozzetto::undo
