// Solids as bytes, for scene files, undo-files and the journal.
#pragma once
#include "bozzetto/base/bytes.hpp"
#include "bozzetto/solid/solid.hpp"

namespace bozzetto {

/// Little endian, format in src/solid/NOTES.md. Null is no bytes.
Bytes encodeSolid(const SolidRef& solid);

/// Throws Error for anything but a sound solid; allocates no more than the bytes call for.
/// `name` opens the text.
SolidRef decodeSolid(std::span<const std::byte> bytes, std::string_view name);

/// What changed between two solids: places only where nothing else did, else all of the later one.
/// `before` and the bytes give `after` again, bit for bit.
Bytes encodeSolidDelta(const SolidRef& before, const SolidRef& after);
SolidRef applySolidDelta(const SolidRef& before, std::span<const std::byte> bytes,
                         std::string_view name);

}  // namespace bozzetto
