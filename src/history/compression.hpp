// zstd frames of known size, for readers who trust nobody.
#pragma once
#include <cstddef>
#include <span>
#include <string>

#include "bozzetto/base/bytes.hpp"

namespace bozzetto::undo {

/// One frame. `level` as zstd has it.
Bytes compressed(std::span<const std::byte> raw, int level);

/// What `compressed` was given. Throws Error, `name` first, unless it is one frame of `rawBytes`.
Bytes decompressed(std::span<const std::byte> frame, std::size_t rawBytes, const std::string& name);

}  // namespace bozzetto::undo
