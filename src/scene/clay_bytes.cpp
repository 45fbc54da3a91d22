#include "bozzetto/scene/clay_bytes.hpp"

#include <algorithm>
#include <cmath>

#include "scene/tiles.hpp"

namespace bozzetto {
namespace {

constexpr std::uint32_t kMagic = 0x31434c42;  // "BLC1"

// Chunks in any order, each tile once, no run over another.
void putChunk(const Chunk& chunk, Clay& clay, const std::string& name) {
  for (const ChunkRun& run : chunk.runs) {
    bool free = true;
    forPieces(clay.tree, run.run,
              [&](KeyRun, const Ref<CornerBlock<8>>& there) { free = free && !there; });
    if (!free) throw Error(name + ": runs overlap at block " + toText(run.run.key));
    clay.tree.put(run.run.key, run.run.length, run.block);
  }
}

}  // namespace

Bytes encodeClay(const Clay& clay) {
  ByteWriter out;
  out.put(kMagic);
  out.put(clay.scale.spacing);
  out.put(clay.scale.iso);
  const std::vector<Key> tiles = tilesOf(clay.tree);
  out.put(static_cast<std::uint32_t>(tiles.size()));
  for (const Key& tile : tiles) {
    const Bytes chunk = encodeChunk(chunkAt(clay.tree, tile));
    out.put(static_cast<std::uint32_t>(chunk.size()));
    out.put(chunk);
  }
  return out.take();
}

Clay decodeClay(std::span<const std::byte> bytes, const std::string& name) {
  ByteReader in(bytes, name);
  if (in.get<std::uint32_t>() != kMagic) throw Error(name + ": no clay found at byte 0");
  Clay clay;
  clay.scale.spacing = in.get<double>();
  clay.scale.iso = in.get<float>();
  const FieldScale& scale = clay.scale;
  if (!(scale.spacing >= 1e-100 && scale.spacing <= 1e100 && scale.iso > 0 && scale.iso < 1)) {
    throw Error(name + ": spacing and iso are out of range");
  }
  for (auto left = in.get<std::uint32_t>(); left > 0; --left) {
    const auto size = in.get<std::uint32_t>();
    putChunk(decodeChunk(in.take(size), name), clay, name);
  }
  if (in.remaining() != 0) throw Error(name + ": more bytes than its chunks");
  for (const auto& [key, run] : Clay(clay).tree) clay.tree.join(key);
  return clay;
}

}  // namespace bozzetto
