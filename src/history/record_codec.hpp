// A packed record as bytes, uncompressed. NOTES.md has the layout.
#pragma once
#include <string>

#include "bozzetto/base/bytes.hpp"
#include "history/packed_record.hpp"

namespace bozzetto::undo {

/// No record of blocks of this side is longer.
template <int Side>
constexpr std::size_t mostRecordBytes() {
  constexpr std::size_t mask = PackedRecord<Side>::kMaskWords * 8;
  constexpr std::size_t words = std::size_t{4} * CornerBlock<Side>::kCount;
  return 4 + kRecordChanges * (13 + 20 + 2 * (mask + words)) + 16;
}

template <int Side>
Bytes encodeRecord(const PackedRecord<Side>& record);

/// What encodeRecord made, or Error with `name` first: nothing is taken on trust but that unpacking
/// looks at the content.
template <int Side>
PackedRecord<Side> decodeRecord(std::span<const std::byte> raw, const std::string& name);

}  // namespace bozzetto::undo
