#include "scene/chunk_codec.hpp"

#include <zstd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <memory>

#include "bozzetto/base/word_planes.hpp"

namespace bozzetto {
namespace {

using Block = CornerBlock<8>;

constexpr int kTileKeys = 512;
constexpr int kCodeBytes = Block::kCount / 4;
constexpr int kLevel = 1;
constexpr float kValueLimit = 2048;

enum Kind : std::uint8_t { kOwn = 0, kUniform = 1 };
enum Code : std::uint8_t { kEmpty = 0, kFull = 1, kOther = 2 };
constexpr std::byte kFourFull{0x55};
enum AttributeMode : std::uint8_t { kOneForAll = 0, kOneEach = 1 };

// Every block its own colours and values, and no run shorter than its record.
constexpr std::size_t kMostRaw =
    4 + kTileKeys * (3 + 12) + kTileKeys * (1 + kCodeBytes + std::size_t{8} * Block::kCount) + 8;

bool goodValue(float value) { return value > 0 && value < kValueLimit; }  // and no NaN

void putCounted(ByteWriter& out, const std::vector<std::uint32_t>& words) {
  out.put(static_cast<std::uint32_t>(words.size()));
  putPlanes(out, words);
}

std::vector<std::uint32_t> getCounted(ByteReader& in, std::size_t expected,
                                      const std::string& name) {
  const auto count = in.get<std::uint32_t>();
  if (count != expected) {
    throw Error(name + ": " + std::to_string(count) + " words in planes, " +
                std::to_string(expected) + " expected");
  }
  return getPlanes(in, count);
}

// The streams of all own blocks of a chunk.
struct BlockStreams {
  Bytes codes, modes;
  std::vector<std::uint32_t> values, attributes;
};

constexpr auto kOneBits = std::bit_cast<std::uint32_t>(1.0f);

// The codes of four corners in one byte; values that are neither 0 nor 1 go to `others`.
std::byte codesOf(const float* value, std::uint32_t*& others) {
  std::array<std::uint32_t, 4> bits;
  std::memcpy(bits.data(), value, sizeof bits);
  if ((bits[0] | bits[1] | bits[2] | bits[3]) << 1 == 0) return std::byte{0};
  std::uint32_t notFull = 0;
  for (const std::uint32_t each : bits) notFull |= each ^ kOneBits;
  if (notFull == 0) return kFourFull;
  unsigned codes = 0;
  for (int n = 0; n < 4; ++n) {
    const unsigned code = bits[n] << 1 == 0 ? kEmpty : bits[n] == kOneBits ? kFull : kOther;
    codes |= code << 2 * n;
    *others = bits[n];
    others += code >> 1;
  }
  return static_cast<std::byte>(codes);
}

void addCodes(const Block& block, BlockStreams& out) {
  const std::size_t codesBefore = out.codes.size(), valuesBefore = out.values.size();
  out.codes.resize(codesBefore + kCodeBytes);
  out.values.resize(valuesBefore + Block::kCount);
  std::uint32_t* others = out.values.data() + valuesBefore;
  for (int n = 0; n < kCodeBytes; ++n) {
    out.codes[codesBefore + n] = codesOf(&block.value[n * 4], others);
  }
  out.values.resize(others - out.values.data());
}

void addAttributes(const Block& block, BlockStreams& out) {
  int first = 0;
  while (!(block.value[first] > 0)) ++first;
  Attributes differs = 0;
  for (int n = 0; n < Block::kCount; ++n) {
    differs |= block.value[n] > 0 ? block.attributes[n] ^ block.attributes[first] : 0;
  }
  out.modes.push_back(static_cast<std::byte>(differs == 0 ? kOneForAll : kOneEach));
  if (differs == 0) return out.attributes.push_back(block.attributes[first]);
  for (int n = 0; n < Block::kCount; ++n) {
    if (block.value[n] > 0) out.attributes.push_back(block.attributes[n]);
  }
}

void requireGood(const Block& block, Key key) {
  // As integers: floats ≥ 0 are in the order of their bits, all others are larger.
  constexpr auto kLimitBits = std::bit_cast<std::uint32_t>(kValueLimit);
  std::uint32_t most = 0;
  for (const float value : block.value) most = std::max(most, std::bit_cast<std::uint32_t>(value));
  if (most > 0 && most < kLimitBits) return;
  throw Error("block " + toText(key) + ": densities outside 0 … 2048, or none, cannot be saved");
}

Bytes rawChunk(const Chunk& chunk) {
  ByteWriter out;
  BlockStreams streams;
  out.put(static_cast<std::uint32_t>(chunk.runs.size()));
  for (const auto& [run, block] : chunk.runs) {
    requireGood(*block, run.key);
    const Key in{run.key.i & 7, run.key.j & 7, run.key.k & 7};
    out.put(static_cast<std::uint16_t>((in.i * 8 + in.j) * 8 + in.k));
    out.put(static_cast<std::uint8_t>(block->interned ? kUniform : kOwn));
    if (block->interned) {
      out.put(run.length);
      out.put(block->value[0]);
      out.put(block->attributes[0]);
    } else {
      addCodes(*block, streams);
      addAttributes(*block, streams);
    }
  }
  out.put(std::span<const std::byte>(streams.modes));
  out.put(std::span<const std::byte>(streams.codes));
  putCounted(out, streams.values);
  putCounted(out, streams.attributes);
  return out.take();
}

[[noreturn]] void refuse(const std::string& name, Key key, const std::string& what) {
  throw Error(name + ": block " + toText(key) + ": " + what);
}

// Corners beyond the workspace's rim hold nothing.
void requireInside(const Chunk& chunk, const std::string& name) {
  constexpr std::int32_t kRim = kWorkspaceRim / 8;
  for (const auto& [run, block] : chunk.runs) {
    bool beyond = false, atRim = false;
    for (const Axis axis : kAxes) {
      const std::int64_t last =
          std::int64_t{run.key[axis]} + (axis == Axis::z ? run.length - 1 : 0);
      beyond |= run.key[axis] < -kRim || last > kRim;
      atRim |= last == kRim;
    }
    if (beyond) refuse(name, run.key, "leaves the workspace of ±2^30 cells");
    if (!atRim) continue;
    for (int n = 0; n < Block::kCount; ++n) {
      const Key in{n / 64, n / 8 % 8, n % 8};
      for (const Axis axis : kAxes) {
        if (run.key[axis] + (axis == Axis::z ? run.length - 1 : 0) == kRim && in[axis] > 0 &&
            block->value[n] > 0) {
          refuse(name, run.key, "leaves the workspace of ±2^30 cells");
        }
      }
    }
  }
}

ChunkRun getRun(ByteReader& in, Key tile, int& last, const std::string& name) {
  const int place = in.get<std::uint16_t>();
  if (place <= last || place >= kTileKeys) {
    throw Error(name + ": run at place " + std::to_string(place) + ", more than " +
                std::to_string(last) + " and less than 512 expected");
  }
  last = place;
  ChunkRun run{{tile * 8 + Key{place / 64, place / 8 % 8, place % 8}, 1}, nullptr};
  const auto kind = in.get<std::uint8_t>();
  if (kind == kOwn) return run;
  if (kind != kUniform) refuse(name, run.run.key, "kind " + std::to_string(kind) + " unknown");
  run.run.length = in.get<std::int32_t>();
  const auto value = in.get<float>();
  const auto attributes = in.get<std::uint32_t>();
  if (run.run.length < 1 || run.run.length > kWorkspaceRim) {
    refuse(name, run.run.key, "run of length " + std::to_string(run.run.length));
  }
  if (!goodValue(value)) refuse(name, run.run.key, "density outside 0 … 2048");
  run.block = Block::uniform(value, attributes);
  return run;
}

// How many of the four corners of a code byte have clay, how many their own value, and whether all
// codes are known.
struct CodeCounts {
  int clay, others;
  bool known;
};

constexpr std::array<CodeCounts, 256> kCodeCounts = [] {
  std::array<CodeCounts, 256> table{};
  for (unsigned byte = 0; byte < 256; ++byte) {
    table[byte].known = true;
    for (int n = 0; n < 4; ++n) {
      const unsigned code = byte >> 2 * n & 3;
      table[byte].clay += code != kEmpty ? 1 : 0;
      table[byte].others += code == kOther ? 1 : 0;
      table[byte].known &= code <= kOther;
    }
  }
  return table;
}();

// Where the last block left off in the streams.
struct StreamPlace {
  std::size_t value = 0, attribute = 0;
};

void fillFour(std::byte codes, float* value, const BlockStreams& streams, StreamPlace& place) {
  for (int n = 0; n < 4; ++n) {
    const unsigned code = std::to_integer<unsigned>(codes) >> 2 * n & 3;
    if (code == kFull) value[n] = 1.0f;
    if (code == kOther) value[n] = std::bit_cast<float>(streams.values[place.value++]);
  }
}

Ref<Block> blockOf(std::span<const std::byte> codes, std::byte mode, const BlockStreams& streams,
                   StreamPlace& place) {
  Ref<Block> block(new Block());
  for (int n = 0; n < kCodeBytes; ++n) {
    float* value = &block->value[n * 4];
    if (codes[n] == std::byte{0}) continue;
    if (codes[n] == kFourFull) {
      std::fill_n(value, 4, 1.0f);
    } else {
      fillFour(codes[n], value, streams, place);
    }
  }
  if (mode == std::byte{kOneForAll}) {
    block->attributes.fill(streams.attributes[place.attribute++]);  // canonical() clears the empty
    return block;
  }
  for (int n = 0; n < Block::kCount; ++n) {
    if (block->value[n] > 0) block->attributes[n] = streams.attributes[place.attribute++];
  }
  return block;
}

struct StreamSizes {
  std::size_t values = 0, attributes = 0;
};

StreamSizes sizesOf(std::span<const std::byte> codes, std::span<const std::byte> modes,
                    const std::string& name) {
  StreamSizes sizes;
  for (std::size_t b = 0; b < modes.size(); ++b) {
    std::size_t clay = 0;
    for (const std::byte code : codes.subspan(b * kCodeBytes, kCodeBytes)) {
      const CodeCounts& counts = kCodeCounts[std::to_integer<std::size_t>(code)];
      if (!counts.known) throw Error(name + ": corner code 3, at most 2 expected");
      clay += counts.clay;
      sizes.values += counts.others;
    }
    if (modes[b] > std::byte{kOneEach}) throw Error(name + ": attribute mode unknown");
    sizes.attributes += modes[b] == std::byte{kOneEach} ? clay : 1;
  }
  return sizes;
}

void getOwnBlocks(ByteReader& in, Chunk& chunk, const std::string& name) {
  std::size_t own = 0;
  for (const ChunkRun& run : chunk.runs) own += run.block ? 0 : 1;
  const auto modes = in.take(own);
  const auto codes = in.take(own * kCodeBytes);
  const StreamSizes sizes = sizesOf(codes, modes, name);
  BlockStreams streams;
  streams.values = getCounted(in, sizes.values, name);
  streams.attributes = getCounted(in, sizes.attributes, name);
  for (const std::uint32_t bits : streams.values) {
    const auto value = std::bit_cast<float>(bits);
    if (!goodValue(value) || value == 1) throw Error(name + ": density outside 0 … 2048, or 1");
  }
  StreamPlace place;
  std::size_t b = 0;
  for (ChunkRun& run : chunk.runs) {
    if (run.block) continue;
    run.block = Block::canonical(
        blockOf(codes.subspan(b * kCodeBytes, kCodeBytes), modes[b], streams, place));
    ++b;
    if (!run.block || run.block->interned) refuse(name, run.run.key, "equal corners in own block");
  }
}

struct FreeCompressor {
  void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
};
struct FreeDecompressor {
  void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
};

Bytes decompressed(std::span<const std::byte> frame, std::size_t size, const std::string& name) {
  static thread_local const std::unique_ptr<ZSTD_DCtx, FreeDecompressor> context(ZSTD_createDCtx());
  if (size > kMostRaw) {
    throw Error(name + ": " + std::to_string(size) + " bytes of clay, at most " +
                std::to_string(kMostRaw) + " expected");
  }
  if (ZSTD_getFrameContentSize(frame.data(), frame.size()) != size ||
      ZSTD_findFrameCompressedSize(frame.data(), frame.size()) != frame.size()) {
    throw Error(name + ": not one zstd frame of " + std::to_string(size) + " bytes");
  }
  Bytes raw(size);
  const std::size_t got =
      ZSTD_decompressDCtx(context.get(), raw.data(), raw.size(), frame.data(), frame.size());
  if (got != size) throw Error(name + ": zstd frame does not decompress");
  return raw;
}

}  // namespace

Bytes encodeChunk(const Chunk& chunk) {
  static thread_local const std::unique_ptr<ZSTD_CCtx, FreeCompressor> context(ZSTD_createCCtx());
  const Bytes raw = rawChunk(chunk);
  ByteWriter head;
  for (const Axis axis : kAxes) head.put(chunk.tile[axis]);
  head.put(static_cast<std::uint32_t>(raw.size()));
  Bytes bytes = head.take();
  const std::size_t before = bytes.size();
  bytes.resize(before + ZSTD_compressBound(raw.size()));
  const std::size_t size = ZSTD_compressCCtx(context.get(), bytes.data() + before,
                                             bytes.size() - before, raw.data(), raw.size(), kLevel);
  if (ZSTD_isError(size)) throw Error(std::string("zstd: ") + ZSTD_getErrorName(size));
  bytes.resize(before + size);
  return bytes;
}

Chunk decodeChunk(std::span<const std::byte> bytes, const std::string& name) {
  ByteReader head(bytes, name);
  Key tile;
  constexpr std::int32_t kTileRim = kWorkspaceRim / 64;
  for (const Axis axis : kAxes) {
    tile[axis] = head.get<std::int32_t>();
    if (tile[axis] < -kTileRim || tile[axis] > kTileRim) {
      throw Error(name + ": tile " + std::to_string(tile[axis]) + " outside ±2^24");
    }
  }
  const auto size = head.get<std::uint32_t>();
  return decodeRawChunk(tile, decompressed(head.take(head.remaining()), size, name), name);
}

Chunk decodeRawChunk(Key tile, std::span<const std::byte> raw, const std::string& name) {
  ByteReader in(raw, name);
  Chunk chunk{tile, {}};
  const auto runs = in.get<std::uint32_t>();
  if (runs < 1 || runs > kTileKeys) {
    throw Error(name + ": " + std::to_string(runs) + " runs, 1 to 512 expected");
  }
  int last = -1;
  for (std::uint32_t n = 0; n < runs; ++n) {
    chunk.runs.push_back(getRun(in, chunk.tile, last, name));
  }
  getOwnBlocks(in, chunk, name);
  if (in.remaining() > 0) {
    throw Error(name + ": " + std::to_string(in.remaining()) + " bytes too many");
  }
  requireInside(chunk, name);
  return chunk;
}

}  // namespace bozzetto
