#include "history/packed_record.hpp"

#include <algorithm>
#include <bit>

#include "bozzetto/base/error.hpp"
#include "bozzetto/base/hash.hpp"

namespace bozzetto::undo {
namespace {

static_assert(std::endian::native == std::endian::little, "content hashes are of memory's bytes");

template <int Side>
using Words = std::array<std::uint32_t, CornerBlock<Side>::kCount>;

template <int Side>
Words<Side> valueWords(const CornerBlock<Side>* block) {
  return block == nullptr ? Words<Side>{} : std::bit_cast<Words<Side>>(block->value);
}

template <int Side>
Words<Side> attributeWords(const CornerBlock<Side>* block) {
  return block == nullptr ? Words<Side>{} : block->attributes;
}

template <class Array>
void addTo(Hasher& hasher, const Array& words) {
  hasher.add(std::as_bytes(std::span(words)));
}

// Zigzag: 0, −1, 1, −2 … become 0, 1, 2, 3 …
constexpr std::uint32_t folded(std::uint32_t difference) {
  return difference << 1 ^ (0u - (difference >> 31));
}
constexpr std::uint32_t unfolded(std::uint32_t word) { return word >> 1 ^ (0u - (word & 1)); }

struct ValueChannel {
  static std::uint32_t difference(std::uint32_t before, std::uint32_t after) {
    return folded(after - before);
  }
  static std::uint32_t applied(std::uint32_t old, std::uint32_t word, Direction direction) {
    return direction == Direction::forward ? old + unfolded(word) : old - unfolded(word);
  }
};

struct AttributeChannel {
  static std::uint32_t difference(std::uint32_t before, std::uint32_t after) {
    return before ^ after;
  }
  static std::uint32_t applied(std::uint32_t old, std::uint32_t word, Direction) {
    return old ^ word;
  }
};

bool allSame(std::span<const std::uint32_t> words) {
  return std::all_of(words.begin(), words.end(), [&](std::uint32_t w) { return w == words[0]; });
}

// Adds the words of one block's channel to the record.
template <class Rule, int Side>
Channel packChannel(const Words<Side>& before, const Words<Side>& after, PackedRecord<Side>& record,
                    std::vector<std::uint32_t>& words) {
  typename PackedRecord<Side>::Mask mask{};
  const std::size_t first = words.size();
  for (std::size_t n = 0; n < before.size(); ++n) {
    if (before[n] == after[n]) continue;
    mask[n / 64] |= std::uint64_t{1} << (n % 64);
    words.push_back(Rule::difference(before[n], after[n]));
  }
  const std::size_t count = words.size() - first;
  if (count == 0) return {};
  Channel channel{count == before.size() ? Spread::all : Spread::some,
                  allSame(std::span(words).subspan(first))};
  if (channel.spread == Spread::some) record.masks.push_back(mask);
  if (channel.oneWord) words.resize(first + 1);
  return channel;
}

template <int Side>
bool isUniform(const Ref<CornerBlock<Side>>& block) {
  return Side == 1 || !block || block->interned;
}

template <int Side>
Uniform uniformOf(const Ref<CornerBlock<Side>>& block) {
  return block ? Uniform{block->value[0], block->attributes[0]} : Uniform{};
}

template <int Side>
Ref<CornerBlock<Side>> blockOf(const Uniform& content) {
  if (content.value == 0) return nullptr;
  return CornerBlock<Side>::uniform(content.value, content.attributes);
}

template <int Side>
struct Packer {
  PackedRecord<Side> record;
  Hasher before, after;

  void add(const Change<CornerBlock<Side>>& change) {
    PackedChange packed;
    packed.run = {change.key, change.length};
    if (isUniform<Side>(change.before) && isUniform<Side>(change.after)) {
      packed.kind = PackedChange::Kind::run;
      packed.before = uniformOf<Side>(change.before);
      packed.after = uniformOf<Side>(change.after);
    } else {
      addCorners(change, packed);
    }
    record.changes.push_back(packed);
  }

  void addCorners(const Change<CornerBlock<Side>>& change, PackedChange& packed) {
    const auto oldValues = valueWords<Side>(change.before.get());
    const auto newValues = valueWords<Side>(change.after.get());
    const auto oldAttributes = attributeWords<Side>(change.before.get());
    const auto newAttributes = attributeWords<Side>(change.after.get());
    packed.value = packChannel<ValueChannel, Side>(oldValues, newValues, record, record.values);
    packed.attributes = packChannel<AttributeChannel, Side>(oldAttributes, newAttributes, record,
                                                            record.attributes);
    addTo(before, oldValues);
    addTo(before, oldAttributes);
    addTo(after, newValues);
    addTo(after, newAttributes);
  }
};

// Walks through a record's masks and words as its changes ask for them.
template <int Side>
class Unpacker {
 public:
  using Block = CornerBlock<Side>;
  Unpacker(const PackedRecord<Side>& record, Direction direction, const std::string& name)
      : record_(record), direction_(direction), name_(name) {}

  Ref<Block> corners(const PackedChange& packed, const Block* old) {
    auto values = valueWords<Side>(old);
    auto attributes = attributeWords<Side>(old);
    addTo(before_, values);
    addTo(before_, attributes);
    apply<ValueChannel>(packed.value, record_.values, valueAt_, values);
    apply<AttributeChannel>(packed.attributes, record_.attributes, attributeAt_, attributes);
    addTo(after_, values);
    addTo(after_, attributes);
    requireClay(values, packed.run.key);
    Ref<Block> block(new Block(ForOverwrite{}));
    block->value = std::bit_cast<decltype(block->value)>(values);
    block->attributes = attributes;
    return Block::canonical(std::move(block));
  }

  // The record was made from exactly this.
  void requireFit() const {
    const bool forward = direction_ == Direction::forward;
    if (before_.result() != (forward ? record_.hashBefore : record_.hashAfter)) {
      throw Error(name_ + ": does not fit the clay it is applied to");
    }
    if (after_.result() != (forward ? record_.hashAfter : record_.hashBefore)) {
      throw Error(name_ + ": its differences do not give the clay it promises");
    }
  }

 private:
  template <class Rule>
  void apply(Channel channel, const std::vector<std::uint32_t>& words, std::size_t& at,
             Words<Side>& content) {
    if (channel.spread == Spread::none) return;
    const auto* mask = channel.spread == Spread::some ? &record_.masks[maskAt_++] : nullptr;
    for (std::size_t n = 0; n < content.size(); ++n) {
      if (mask != nullptr && ((*mask)[n / 64] >> (n % 64) & 1) == 0) continue;
      content[n] = Rule::applied(content[n], words[at], direction_);
      at += channel.oneWord ? 0 : 1;
    }
    at += channel.oneWord ? 1 : 0;
  }

  // As integers: floats ≥ 0 are in the order of their bits, all others are larger.
  void requireClay(const Words<Side>& values, Key key) const {
    constexpr auto kLimitBits = std::bit_cast<std::uint32_t>(2048.0f);
    if (*std::max_element(values.begin(), values.end()) < kLimitBits) return;
    throw Error(name_ + ": block " + toText(key) + ": densities outside 0 … 2048");
  }

  const PackedRecord<Side>& record_;
  Direction direction_;
  const std::string& name_;
  std::size_t maskAt_ = 0, valueAt_ = 0, attributeAt_ = 0;
  Hasher before_, after_;
};

template <int Side>
void requireUniform(const KeyTree<CornerBlock<Side>>& tree, KeyRun run,
                    const Ref<CornerBlock<Side>>& expected, const std::string& name) {
  forPieces(tree, run, [&](KeyRun piece, const Ref<CornerBlock<Side>>& found) {
    if (isUniform<Side>(found) && uniformOf<Side>(found) == uniformOf<Side>(expected)) return;
    throw Error(name + ": block " + toText(piece.key) + ": does not fit the clay");
  });
}

}  // namespace

template <int Side>
std::uint64_t PackedRecord<Side>::changedCorners() const {
  std::uint64_t corners = 0;
  std::size_t mask = 0;
  for (const PackedChange& change : changes) {
    if (change.kind == PackedChange::Kind::run) {
      corners += static_cast<std::uint64_t>(change.run.length) * Block::kCount;
      continue;
    }
    Mask any{};
    for (const Channel channel : {change.value, change.attributes}) {
      if (channel.spread == Spread::all) any.fill(~std::uint64_t{0});
      if (channel.spread != Spread::some) continue;
      for (int n = 0; n < kMaskWords; ++n) any[n] |= masks[mask][n];
      ++mask;
    }
    std::uint64_t here = 0;
    for (const std::uint64_t word : any) here += static_cast<std::uint64_t>(std::popcount(word));
    corners += std::min<std::uint64_t>(here, Block::kCount);
  }
  return corners;
}

template <int Side>
PackedRecord<Side> pack(std::span<const Change<CornerBlock<Side>>> changes) {
  Packer<Side> packer;
  for (const auto& change : changes) packer.add(change);
  packer.record.hashBefore = packer.before.result();
  packer.record.hashAfter = packer.after.result();
  return std::move(packer.record);
}

template <int Side>
std::vector<Change<CornerBlock<Side>>> unpack(const PackedRecord<Side>& record,
                                              const KeyTree<CornerBlock<Side>>& tree,
                                              Direction direction, const std::string& name) {
  using Block = CornerBlock<Side>;
  const bool forward = direction == Direction::forward;
  Unpacker<Side> unpacker(record, direction, name);
  std::vector<Change<Block>> changes;
  changes.reserve(record.changes.size());
  for (const PackedChange& packed : record.changes) {
    Change<Block> change{packed.run.key, packed.run.length, nullptr, nullptr};
    if (packed.kind == PackedChange::Kind::run) {
      const auto from = blockOf<Side>(forward ? packed.before : packed.after);
      requireUniform<Side>(tree, packed.run, from, name);
      (forward ? change.before : change.after) = from;
      (forward ? change.after : change.before) =
          blockOf<Side>(forward ? packed.after : packed.before);
    } else {
      Ref<Block> old(tree.find(packed.run.key));
      Ref<Block> made = unpacker.corners(packed, old.get());
      change.before = forward ? old : made;
      change.after = forward ? made : old;
    }
    changes.push_back(std::move(change));
  }
  unpacker.requireFit();
  return changes;
}

template struct PackedRecord<1>;
template struct PackedRecord<8>;
template PackedRecord<1> pack(std::span<const Change<CornerBlock<1>>>);
template PackedRecord<8> pack(std::span<const Change<CornerBlock<8>>>);
template std::vector<Change<CornerBlock<1>>> unpack(const PackedRecord<1>&,
                                                    const KeyTree<CornerBlock<1>>&, Direction,
                                                    const std::string&);
template std::vector<Change<CornerBlock<8>>> unpack(const PackedRecord<8>&,
                                                    const KeyTree<CornerBlock<8>>&, Direction,
                                                    const std::string&);

}  // namespace bozzetto::undo
