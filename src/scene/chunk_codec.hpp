// Clay as bytes: the runs that begin in one tile of 8×8×8 block keys make one chunk. The bytes are
// written down in NOTES.md.
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "bozzetto/base/bytes.hpp"
#include "bozzetto/field/field.hpp"

namespace bozzetto {

/// The tile of a block key, in units of 8 blocks.
constexpr Key tileOf(Key block) { return {block.i >> 3, block.j >> 3, block.k >> 3}; }

struct ChunkRun {
  KeyRun run;
  Ref<CornerBlock<8>> block;
};

struct Chunk {
  Key tile;
  std::vector<ChunkRun> runs;
};

/// The runs begin in the tile and are in key order. Throws Error for values that no reader would
/// take.
Bytes encodeChunk(const Chunk& chunk);

/// What encodeChunk made, or Error: `name` opens the text. Blocks come out canonical.
Chunk decodeChunk(std::span<const std::byte> bytes, const std::string& name);

/// The part of decodeChunk behind the compression.
Chunk decodeRawChunk(Key tile, std::span<const std::byte> raw, const std::string& name);

}  // namespace bozzetto
