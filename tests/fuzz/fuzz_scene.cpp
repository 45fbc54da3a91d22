// What stands in the rows of a scene file. The first byte chooses the kind of row.
#include <cstdlib>

#include "bozzetto/scene/support_bytes.hpp"
#include "scene/chunk_codec.hpp"
#include "scene/parts_codec.hpp"

namespace {

using namespace bozzetto;

// Outside the try: a chunk that we cannot write and read again is our bug.
void requireRoundTrip(const Chunk& chunk) {
  const Chunk again = decodeChunk(encodeChunk(chunk), "again");
  if (again.runs.size() != chunk.runs.size()) std::abort();
  for (std::size_t n = 0; n < chunk.runs.size(); ++n) {
    if (!again.runs[n].block->sameAs(*chunk.runs[n].block)) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const auto bytes = std::as_bytes(std::span(data + 1, size - 1));
  Chunk chunk;
  try {
    if (data[0] == 0) chunk = decodeChunk(bytes, "fuzz");
    if (data[0] == 1) chunk = decodeRawChunk({}, bytes, "fuzz");
    if (data[0] == 2) decodeHead(bytes, "fuzz");
    if (data[0] == 3) decodeView(bytes, "fuzz");
    if (data[0] == 4) decodeItem(bytes, "fuzz");
  } catch (const Error&) {
    return 0;
  }
  if (!chunk.runs.empty()) requireRoundTrip(chunk);
  return 0;
}
