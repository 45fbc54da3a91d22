// Clay as bytes of its own: what shelf items keep of a tool. The chunks of scene files, one after
// the other.
#pragma once
#include <span>
#include <string>

#include "bozzetto/base/bytes.hpp"
#include "bozzetto/field/field.hpp"

namespace bozzetto {

/// Throws Error for values that no reader would take. O(blocks).
Bytes encodeClay(const Clay& clay);

/// What encodeClay made, or Error; `name` opens its text. Allocates nothing that the bytes do not
/// bear out.
Clay decodeClay(std::span<const std::byte> bytes, const std::string& name);

}  // namespace bozzetto
