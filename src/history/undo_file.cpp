#include "history/undo_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "bozzetto/base/hash.hpp"
#include "bozzetto/base/parallel.hpp"
#include "history/compression.hpp"
#include "history/record_codec.hpp"

namespace bozzetto::undo {
namespace {

constexpr std::string_view kMagic = "bzzundo\n";
constexpr std::uint32_t kVersion = 3, kSolidAlone = 2, kWithoutSolids = 1;
constexpr int kLevel = 3;
constexpr std::size_t kMostLabelBytes = 255;
constexpr std::size_t kBatch = 16;  // records in memory at a time

std::uint64_t frameHash(std::span<const std::byte> packed, std::uint64_t mark,
                        std::uint32_t index) {
  ByteWriter place;
  place.put(mark);
  place.put(index);
  Hasher hasher;
  hasher.add(packed);
  hasher.add(place.bytes());
  return hasher.result();
}

// What comes before frames: two lengths and a hash. The last has lengths 0 and the count of frames.
void putFrame(ByteWriter& out, std::span<const std::byte> packed, std::size_t rawBytes,
              std::uint64_t hash) {
  out.put(static_cast<std::uint32_t>(rawBytes));
  out.put(static_cast<std::uint32_t>(packed.size()));
  out.put(hash);
  out.put(packed);
}

void putScale(ByteWriter& out, const FieldScale& scale) {
  out.put(scale.spacing);
  out.put(scale.iso);
}

FieldScale getScale(ByteReader& in, const std::string& name) {
  FieldScale scale;
  scale.spacing = in.get<double>();
  scale.iso = in.get<float>();
  const bool good = scale.spacing >= 1e-100 && scale.spacing <= 1e100 && scale.iso > 0 &&
                    scale.iso < 1;  // and no NaN
  if (!good) throw Error(name + ": spacing or iso out of range");
  return scale;
}

Bytes encodeHead(const FileHead& head) {
  const std::string label = head.step.note.label.substr(0, kMostLabelBytes);
  ByteWriter out;
  out.put(kMagic);
  out.put(kVersion);
  out.put(static_cast<std::uint8_t>(head.kind));
  out.put(head.side);
  out.put(static_cast<std::uint16_t>(label.size()));
  out.put(head.thumbnailBytes);
  out.put(head.besideBytes);
  out.put(head.fileBytes);
  for (const std::uint8_t byte : head.identity) out.put(byte);
  out.put(head.moment);
  out.put(head.step.number);
  out.put(head.step.parent);
  out.put(head.step.mark);
  out.put(head.step.parentMark);
  out.put(head.step.time);
  putScale(out, head.step.note.before);
  putScale(out, head.step.note.after);
  out.put(head.step.changedBlocks);
  out.put(head.step.changedCorners);
  out.put(std::string_view(label));
  out.put(hash64(out.bytes()));
  return out.take();
}

// A picture, what is beside the clay: their lengths are in the head.
void putEnclosure(ByteWriter& out, std::span<const std::byte> bytes) {
  if (bytes.empty()) return;
  out.put(bytes);
  out.put(hash64(bytes));
}

std::uint64_t lengthOf(std::span<const std::byte> enclosure) {
  return enclosure.empty() ? 0 : enclosure.size() + 8;
}

std::span<const std::byte> takeEnclosure(ByteReader& in, std::size_t length,
                                         const std::string& name) {
  if (length == 0) return {};
  const auto bytes = in.take(length);
  if (in.get<std::uint64_t>() != hash64(bytes)) throw Error(name + " does not match its hash");
  return bytes;
}

template <int Side>
struct EncodedFrame {
  Bytes packed;
  std::size_t rawBytes = 0;
  std::uint64_t corners = 0;
};

template <int Side>
EncodedFrame<Side> encodeFrame(std::span<const Change<CornerBlock<Side>>> changes) {
  const PackedRecord<Side> record = pack<Side>(changes);
  const Bytes raw = encodeRecord(record);
  return {compressed(raw, kLevel), raw.size(), record.changedCorners()};
}

// Only uniform blocks may stand in runs in a record.
template <int Side>
void addPieces(const Change<CornerBlock<Side>>& change,
               std::vector<Change<CornerBlock<Side>>>& pieces) {
  const auto uniform = [](const auto& block) { return Side == 1 || !block || block->interned; };
  if (change.length == 1 || (uniform(change.before) && uniform(change.after))) {
    return pieces.push_back(change);
  }
  for (std::int32_t n = 0; n < change.length; ++n) {
    pieces.push_back({change.key + Key{0, 0, n}, 1, change.before, change.after});
  }
}

template <int Side>
std::span<const Change<CornerBlock<Side>>> recordOf(
    const std::vector<Change<CornerBlock<Side>>>& pieces, std::size_t index) {
  const std::size_t first = index * kRecordChanges;
  return std::span(pieces).subspan(first, std::min(kRecordChanges, pieces.size() - first));
}

}  // namespace

template <int Side>
Bytes encodeUndoFile(FileHead& head, const Delta<CornerBlock<Side>>& delta,
                     const Enclosures& enclosures) {
  std::vector<Change<CornerBlock<Side>>> pieces;
  for (const auto& change : delta.changes) addPieces<Side>(change, pieces);
  const std::size_t count = (pieces.size() + kRecordChanges - 1) / kRecordChanges;
  std::vector<EncodedFrame<Side>> frames(count);
  parallelFor(count, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) frames[n] = encodeFrame<Side>(recordOf(pieces, n));
  });

  head.side = Side;
  head.thumbnailBytes = static_cast<std::uint32_t>(enclosures.thumbnail.size());
  head.besideBytes = static_cast<std::uint32_t>(enclosures.beside.size());
  head.step.changedBlocks = head.step.changedCorners = 0;
  for (const auto& change : delta.changes) head.step.changedBlocks += change.length;
  for (const auto& frame : frames) head.step.changedCorners += frame.corners;
  head.fileBytes = encodeHead(head).size() + 16;
  head.fileBytes += lengthOf(enclosures.thumbnail) + lengthOf(enclosures.beside);
  for (const auto& frame : frames) head.fileBytes += frame.packed.size() + 16;
  head.step.bytes = head.fileBytes;

  ByteWriter out;
  out.put(std::span<const std::byte>(encodeHead(head)));
  putEnclosure(out, enclosures.thumbnail);
  putEnclosure(out, enclosures.beside);
  std::uint32_t index = 0;
  for (const auto& frame : frames) {
    putFrame(out, frame.packed, frame.rawBytes, frameHash(frame.packed, head.step.mark, index++));
  }
  putFrame(out, {}, 0, frameHash({}, head.step.mark, index));
  return out.take();
}

FileHead decodeHead(std::span<const std::byte> bytes, const std::string& name) {
  ByteReader in(bytes, name);
  if (std::memcmp(in.take(kMagic.size()).data(), kMagic.data(), kMagic.size()) != 0) {
    throw Error(name + ": not an undo-file");
  }
  const auto version = in.get<std::uint32_t>();
  if (version < kWithoutSolids || version > kVersion) {
    throw Error(name + ": undo-file of version " + std::to_string(version) + ", 1 to 3 expected");
  }
  FileHead head;
  if (version <= kSolidAlone) head.besideForm = BesideForm::solidAlone;
  head.kind = static_cast<FileKind>(in.get<std::uint8_t>());
  head.side = in.get<std::uint8_t>();
  const auto labelBytes = in.get<std::uint16_t>();
  head.thumbnailBytes = in.get<std::uint32_t>();
  head.besideBytes = in.get<std::uint32_t>();
  head.fileBytes = in.get<std::uint64_t>();
  for (std::uint8_t& byte : head.identity) byte = in.get<std::uint8_t>();
  head.moment = in.get<std::uint64_t>();
  head.step.number = in.get<std::uint32_t>();
  head.step.parent = in.get<std::uint32_t>();
  head.step.mark = in.get<std::uint64_t>();
  head.step.parentMark = in.get<std::uint64_t>();
  head.step.time = in.get<std::int64_t>();
  head.step.note.before = getScale(in, name);
  head.step.note.after = getScale(in, name);
  head.step.changedBlocks = in.get<std::uint64_t>();
  head.step.changedCorners = in.get<std::uint64_t>();
  const auto label = in.take(labelBytes);
  head.step.note.label.assign(reinterpret_cast<const char*>(label.data()), label.size());
  head.step.bytes = head.fileBytes;
  const std::uint64_t hash = hash64(bytes.first(in.position()));
  if (in.get<std::uint64_t>() != hash) throw Error(name + ": head does not match its hash");
  const bool step = head.kind == FileKind::step;
  const bool good = (step || head.kind == FileKind::checkpoint) &&
                    (version != kWithoutSolids || head.besideBytes == 0) &&
                    labelBytes <= kMostLabelBytes && head.thumbnailBytes <= kMostThumbnailBytes &&
                    (!step || head.step.parent < head.step.number);
  if (!good) throw Error(name + ": head of an undo-file out of range");
  return head;
}

template <int Side>
UndoFile<Side>::UndoFile(std::span<const std::byte> bytes, std::string name)
    : name_(std::move(name)), head_(decodeHead(bytes, name_)) {
  if (head_.side != Side) throw Error(name_ + ": blocks of another side");
  if (head_.fileBytes != 0 && head_.fileBytes != bytes.size()) {
    throw Error(name_ + ": " + std::to_string(bytes.size()) + " bytes, " +
                std::to_string(head_.fileBytes) + " expected");
  }
  ByteReader in(bytes, name_);
  in.skip(encodeHead(head_).size());
  enclosures_.thumbnail = takeEnclosure(in, head_.thumbnailBytes, name_ + ": thumbnail");
  enclosures_.beside = takeEnclosure(in, head_.besideBytes, name_ + ": what is beside the clay");
  for (bool ended = false; !ended;) {
    const std::string where = name_ + ": record " + std::to_string(frames_.size());
    const auto rawBytes = in.get<std::uint32_t>();
    const auto packedBytes = in.get<std::uint32_t>();
    const auto hash = in.get<std::uint64_t>();
    const auto packed = in.take(packedBytes);
    const auto index = static_cast<std::uint32_t>(frames_.size());
    if (hash != frameHash(packed, head_.step.mark, index)) {
      throw Error(where + " does not match its hash");
    }
    if (rawBytes > mostRecordBytes<Side>()) throw Error(where + " is too long");
    ended = rawBytes == 0 && packedBytes == 0;
    if (!ended) frames_.push_back({rawBytes, packed});
  }
  if (in.remaining() > 0) {
    throw Error(name_ + ": " + std::to_string(in.remaining()) + " bytes too many");
  }
}

template <int Side>
std::vector<Change<CornerBlock<Side>>> UndoFile<Side>::unpack(const Frame& frame,
                                                              const KeyTree<Block>& tree,
                                                              Direction direction) const {
  const Bytes raw = decompressed(frame.packed, frame.rawBytes, name_);
  return undo::unpack(decodeRecord<Side>(raw, name_), tree, direction, name_);
}

// Records on threads, batch by batch; given on in order.
template <int Side>
template <class Take>
void UndoFile<Side>::unpackAll(const KeyTree<Block>& tree, Direction direction,
                               const Take& take) const {
  std::vector<std::vector<Change<Block>>> batch(kBatch);
  Key last{-kWorkspaceRim, -kWorkspaceRim, -kWorkspaceRim};
  for (std::size_t first = 0; first < frames_.size(); first += kBatch) {
    const std::size_t count = std::min(kBatch, frames_.size() - first);
    parallelFor(count, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) {
        batch[n] = unpack(frames_[first + n], tree, direction);
      }
    });
    for (std::size_t n = 0; n < count; ++n) {
      if (!(last < batch[n].front().key)) throw Error(name_ + ": records out of order");
      last = batch[n].back().key + Key{0, 0, batch[n].back().length - 1};
      take(std::move(batch[n]));
    }
  }
}

template <int Side>
Delta<CornerBlock<Side>> UndoFile<Side>::unpack(const KeyTree<Block>& tree,
                                                Direction direction) const {
  Delta<Block> delta;
  unpackAll(tree, direction, [&](std::vector<Change<Block>>&& changes) {
    delta.changes.insert(delta.changes.end(), std::make_move_iterator(changes.begin()),
                         std::make_move_iterator(changes.end()));
  });
  return delta;
}

template <int Side>
KeyTree<CornerBlock<Side>> UndoFile<Side>::tree() const {
  KeyTree<Block> tree;
  const KeyTree<Block> nothing;
  unpackAll(nothing, Direction::forward, [&](std::vector<Change<Block>>&& changes) {
    for (auto& change : changes) {
      if (change.after) tree.put(change.key, change.length, std::move(change.after));
    }
  });
  return tree;
}

template <int Side>
CheckpointWriter<Side>::CheckpointWriter(const FileHead& head,
                                         const KeyTree<CornerBlock<Side>>& tree,
                                         const Beside& beside)
    : tree_(&tree), node_(tree.begin()), mark_(head.step.mark) {
  FileHead mine = head;
  mine.kind = FileKind::checkpoint;
  mine.side = Side;
  mine.thumbnailBytes = 0;
  mine.fileBytes = 0;
  const Bytes enclosed = encodeBeside(beside);
  mine.besideBytes = static_cast<std::uint32_t>(enclosed.size());
  ByteWriter out;
  out.put(std::span<const std::byte>(encodeHead(mine)));
  putEnclosure(out, enclosed);
  head_ = out.take();
}

template <int Side>
Bytes CheckpointWriter<Side>::next() {
  if (!head_.empty()) return std::exchange(head_, {});
  if (ended_) return {};
  std::vector<Change<CornerBlock<Side>>> pieces;
  for (; node_ != tree_->end() && pieces.size() < kBatch * kRecordChanges; ++node_) {
    addPieces<Side>({node_->first, node_->second.length, nullptr, node_->second.block}, pieces);
  }
  const std::size_t count = (pieces.size() + kRecordChanges - 1) / kRecordChanges;
  std::vector<EncodedFrame<Side>> frames(count);
  parallelFor(count, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) frames[n] = encodeFrame<Side>(recordOf(pieces, n));
  });
  ByteWriter out;
  for (const auto& frame : frames) {
    putFrame(out, frame.packed, frame.rawBytes, frameHash(frame.packed, mark_, frames_++));
  }
  ended_ = node_ == tree_->end();
  if (ended_) putFrame(out, {}, 0, frameHash({}, mark_, frames_));
  return out.take();
}

template Bytes encodeUndoFile(FileHead&, const Delta<CornerBlock<1>>&, const Enclosures&);
template Bytes encodeUndoFile(FileHead&, const Delta<CornerBlock<8>>&, const Enclosures&);
template class UndoFile<1>;
template class UndoFile<8>;
template class CheckpointWriter<1>;
template class CheckpointWriter<8>;

}  // namespace bozzetto::undo
