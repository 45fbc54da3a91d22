#include "history/record_codec.hpp"

#include <bit>
#include <optional>

#include "bozzetto/base/word_planes.hpp"

namespace bozzetto::undo {
namespace {

using Kind = PackedChange::Kind;

// Kind and channels of a change in one byte: kind, 2 bits of value spread, 2 of attribute spread,
// one word for all values, one word for all attributes.
std::uint8_t formOf(const PackedChange& change) {
  const auto bits = [](auto each) { return static_cast<unsigned>(each); };
  return static_cast<std::uint8_t>(
      bits(change.kind) | bits(change.value.spread) << 1 | bits(change.attributes.spread) << 3 |
      bits(change.value.oneWord) << 5 | bits(change.attributes.oneWord) << 6);
}

std::optional<PackedChange> changeOfForm(std::uint8_t form) {
  PackedChange change;
  change.kind = static_cast<Kind>(form & 1);
  change.value = {static_cast<Spread>(form >> 1 & 3), (form >> 5 & 1) != 0};
  change.attributes = {static_cast<Spread>(form >> 3 & 3), (form >> 6 & 1) != 0};
  const auto bad = [](Channel channel) {
    return channel.spread > Spread::some || (channel.oneWord && channel.spread == Spread::none);
  };
  const bool runWithChannels = change.kind == Kind::run && form != 1;
  if (form > 127 || bad(change.value) || bad(change.attributes) || runWithChannels) return {};
  return change;
}

void putChange(ByteWriter& out, const PackedChange& change) {
  out.put(formOf(change));
  for (const Axis axis : kAxes) out.put(change.run.key[axis]);
  if (change.kind != Kind::run) return;
  out.put(change.run.length);
  for (const Uniform& content : {change.before, change.after}) {
    out.put(content.value);
    out.put(content.attributes);
  }
}

// One record's bytes and how its errors begin.
template <int Side>
class Decoder {
 public:
  using Record = PackedRecord<Side>;
  Decoder(std::span<const std::byte> raw, const std::string& name) : in_(raw, name), name_(name) {}

  Record decode() {
    const auto count = in_.get<std::uint32_t>();
    if (count < 1 || count > kRecordChanges) {
      throw Error(name_ + ": " + std::to_string(count) + " changes in a record, 1 to 512 expected");
    }
    for (std::uint32_t n = 0; n < count; ++n) record_.changes.push_back(change());
    const Counts counts = readMasks();
    record_.values = getPlanes(in_, counts.values);
    record_.attributes = getPlanes(in_, counts.attributes);
    record_.hashBefore = in_.template get<std::uint64_t>();
    record_.hashAfter = in_.template get<std::uint64_t>();
    if (in_.remaining() > 0) {
      throw Error(name_ + ": " + std::to_string(in_.remaining()) + " bytes too many");
    }
    return std::move(record_);
  }

 private:
  struct Counts {
    std::size_t values = 0, attributes = 0;
  };

  [[noreturn]] void refuse(Key key, const char* what) const {
    throw Error(name_ + ": block " + toText(key) + ": " + what);
  }

  PackedChange change() {
    const auto form = in_.template get<std::uint8_t>();
    const auto known = changeOfForm(form);
    if (!known) throw Error(name_ + ": unknown form of change " + std::to_string(form));
    PackedChange change = *known;
    for (const Axis axis : kAxes) change.run.key[axis] = in_.template get<std::int32_t>();
    if (change.kind == Kind::run) {
      change.run.length = in_.template get<std::int32_t>();
      change.before = uniform(change.run.key);
      change.after = uniform(change.run.key);
      if (change.before == change.after) refuse(change.run.key, "a run that changes nothing");
    }
    requireInside(change.run);
    requireOrder(change.run);
    return change;
  }

  Uniform uniform(Key key) {
    Uniform content;
    content.value = in_.template get<float>();
    content.attributes = in_.template get<std::uint32_t>();
    const auto bits = std::bit_cast<std::uint32_t>(content.value);
    if (bits >= std::bit_cast<std::uint32_t>(2048.0f)) refuse(key, "density outside 0 … 2048");
    if (bits == 0 && content.attributes != 0) refuse(key, "colour without clay");
    return content;
  }

  void requireInside(const KeyRun& run) const {
    constexpr std::int64_t rim = kWorkspaceRim / Side;
    bool inside = run.length >= 1 && run.key.k + std::int64_t{run.length} - 1 <= rim;
    for (const Axis axis : kAxes) inside &= -rim <= run.key[axis] && run.key[axis] <= rim;
    if (!inside) refuse(run.key, "beyond the workspace");
  }

  void requireOrder(const KeyRun& run) const {
    if (record_.changes.empty()) return;
    const KeyRun& last = record_.changes.back().run;
    if (!(last.key + Key{0, 0, last.length - 1} < run.key)) refuse(run.key, "out of order");
  }

  // Reads the masks and counts the words that they ask for.
  Counts readMasks() {
    Counts counts;
    for (const PackedChange& change : record_.changes) {
      counts.values += wordsOf(change.value, change.run.key);
      counts.attributes += wordsOf(change.attributes, change.run.key);
    }
    return counts;
  }

  std::size_t wordsOf(Channel channel, Key key) {
    if (channel.spread == Spread::none) return 0;
    std::size_t corners = CornerBlock<Side>::kCount;
    if (channel.spread == Spread::some) corners = readMask(key);
    return channel.oneWord ? 1 : corners;
  }

  std::size_t readMask(Key key) {
    typename Record::Mask mask;
    std::size_t corners = 0;
    for (std::uint64_t& word : mask) {
      word = in_.template get<std::uint64_t>();
      corners += static_cast<std::size_t>(std::popcount(word));
    }
    if (corners < 1 || corners >= CornerBlock<Side>::kCount) refuse(key, "mask of none or all");
    record_.masks.push_back(mask);
    return corners;
  }

  ByteReader in_;
  const std::string& name_;
  Record record_;
};

}  // namespace

template <int Side>
Bytes encodeRecord(const PackedRecord<Side>& record) {
  ByteWriter out;
  out.put(static_cast<std::uint32_t>(record.changes.size()));
  for (const PackedChange& change : record.changes) putChange(out, change);
  for (const auto& mask : record.masks)
    for (const std::uint64_t word : mask) out.put(word);
  putPlanes(out, record.values);
  putPlanes(out, record.attributes);
  out.put(record.hashBefore);
  out.put(record.hashAfter);
  return out.take();
}

template <int Side>
PackedRecord<Side> decodeRecord(std::span<const std::byte> raw, const std::string& name) {
  return Decoder<Side>(raw, name).decode();
}

template Bytes encodeRecord(const PackedRecord<1>&);
template Bytes encodeRecord(const PackedRecord<8>&);
template PackedRecord<1> decodeRecord(std::span<const std::byte>, const std::string&);
template PackedRecord<8> decodeRecord(std::span<const std::byte>, const std::string&);

}  // namespace bozzetto::undo
