// The differences of up to 512 changed blocks: only the channel that changed, only the corners that
// changed, good in both directions. Between blocks and bytes; the bytes are in record_codec.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "bozzetto/field/field.hpp"

namespace bozzetto::undo {

inline constexpr std::size_t kRecordChanges = 512;

/// Which corners of a block a channel changed at.
enum class Spread : std::uint8_t { none = 0, all = 1, some = 2 };

struct Channel {
  Spread spread = Spread::none;
  bool oneWord = false;  ///< the same word for all of them
  friend bool operator==(const Channel&, const Channel&) = default;
};

/// Content of all corners of a uniform block; value 0 is no block.
struct Uniform {
  float value = 0;
  Attributes attributes = 0;
  friend bool operator==(const Uniform&, const Uniform&) = default;
};

struct PackedChange {
  enum class Kind : std::uint8_t { corners = 0, run = 1 };
  Kind kind = Kind::corners;
  KeyRun run;
  Channel value, attributes;  ///< of kind corners
  Uniform before, after;      ///< of kind run: the same content at every key of it
};

template <int Side>
struct PackedRecord {
  using Block = CornerBlock<Side>;
  static constexpr int kMaskWords = (Block::kCount + 63) / 64;
  using Mask = std::array<std::uint64_t, kMaskWords>;

  std::vector<PackedChange> changes;
  std::vector<Mask> masks;  ///< of the channels with Spread::some, in order
  /// For each masked corner: density bits after − before, folded so that small differences of
  /// either sign are small; attributes after ^ before.
  std::vector<std::uint32_t> values, attributes;
  /// Of the content of all blocks of kind corners, in order: proof that a difference fits.
  std::uint64_t hashBefore = 0, hashAfter = 0;

  std::uint64_t changedCorners() const;
};

/// At most kRecordChanges changes, in key order, those longer than one block between uniform ones.
template <int Side>
PackedRecord<Side> pack(std::span<const Change<CornerBlock<Side>>> changes);

/// The changes that lead from `tree` one step forward or back. Throws Error, `name` first, where
/// the tree does not hold what the record was made from, or the result would be no clay.
template <int Side>
std::vector<Change<CornerBlock<Side>>> unpack(const PackedRecord<Side>& record,
                                              const KeyTree<CornerBlock<Side>>& tree,
                                              Direction direction, const std::string& name);

}  // namespace bozzetto::undo
