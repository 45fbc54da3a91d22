// Painted stiffness as bytes of its own: a part of scene files, and what steps of the history keep
// of it.
#pragma once
#include <span>
#include <string>

#include "bozzetto/base/bytes.hpp"
#include "bozzetto/clay/stiffness.hpp"

namespace bozzetto {

/// No bytes where nothing is painted. O(blocks painted).
Bytes encodeStiffness(const clay::Stiffness& stiffness);

/// What encodeStiffness made of some, or Error; `name` opens its text. Allocates nothing that the
/// bytes do not bear out.
clay::Stiffness decodeStiffness(std::span<const std::byte> bytes, const std::string& name);

}  // namespace bozzetto
