// Supports as bytes of their own, their sculptures at the end: a part of scene files, and what
// steps of the history keep of them.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "bozzetto/base/bytes.hpp"
#include "bozzetto/clay/stroke.hpp"

namespace bozzetto {

/// O(blocks of the sculptures).
Bytes encodeSupports(const std::vector<clay::Support>& supports);

/// What encodeSupports made, or Error; `name` opens its text. Allocates nothing that the bytes do
/// not bear out.
std::vector<clay::Support> decodeSupports(std::span<const std::byte> bytes,
                                          const std::string& name);

}  // namespace bozzetto
