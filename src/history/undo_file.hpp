// Undo-files (Ferley §3.3): what one step changed, previous and new state of modified corners.
// A checkpoint is the step from nothing to all the clay there is. The bytes are in NOTES.md.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bozzetto/base/bytes.hpp"
#include "bozzetto/history/step.hpp"
#include "history/beside_part.hpp"
#include "history/packed_record.hpp"

namespace bozzetto::undo {

enum class FileKind : std::uint8_t { step = 1, checkpoint = 2 };

struct FileHead {
  FileKind kind = FileKind::step;
  std::uint8_t side = 8;
  HistoryIdentity identity{};
  std::uint64_t moment = 0;  ///< counts every event of a history: what came last
  Step step;                 ///< of a checkpoint: the state it holds
  std::uint32_t thumbnailBytes = 0;
  std::uint32_t besideBytes = 0;
  BesideForm besideForm = BesideForm::whole;  ///< as read
  std::uint64_t fileBytes = 0;  ///< 0 in checkpoints, which are written before this is known
};

/// A head is at most so long: enough to read of a file in order to list it.
inline constexpr std::size_t kMostHeadBytes = 512;
inline constexpr std::size_t kMostThumbnailBytes = 16u << 20;

/// What an undo-file holds beside clay; all may be empty.
struct Enclosures {
  std::span<const std::byte> thumbnail{};
  std::span<const std::byte> beside{};  ///< encodeBesidePart; of a checkpoint encodeBeside
};

/// Counts and file length go into the head.
template <int Side>
Bytes encodeUndoFile(FileHead& head, const Delta<CornerBlock<Side>>& delta,
                     const Enclosures& enclosures = {});

/// From the first bytes of a file. Throws Error with `name` first.
FileHead decodeHead(std::span<const std::byte> bytes, const std::string& name);

/// A file in memory, checked part by part as it is used.
template <int Side>
class UndoFile {
 public:
  using Block = CornerBlock<Side>;
  /// Throws Error, `name` first, unless head and frames are whole. `bytes` must outlive this.
  UndoFile(std::span<const std::byte> bytes, std::string name);

  const FileHead& head() const { return head_; }
  std::span<const std::byte> thumbnail() const { return enclosures_.thumbnail; }

  /// What leads from `tree` over this step. Throws Error where it does not fit. In parallel.
  Delta<Block> unpack(const KeyTree<Block>& tree, Direction direction) const;

  /// What stands beside the clay over this step. Throws Error where `here` does not fit.
  Beside beside(const Beside& here, Direction direction) const {
    return besideBeyond(here, enclosures_.beside, direction, head_.besideForm, name_);
  }
  /// The same of a checkpoint. Throws Error where it is none.
  Beside beside() const { return decodeBeside(enclosures_.beside, head_.besideForm, name_); }

  /// The clay of a checkpoint. In parallel, without a second copy.
  KeyTree<Block> tree() const;

 private:
  struct Frame {
    std::uint32_t rawBytes;
    std::span<const std::byte> packed;
  };
  std::vector<Change<Block>> unpack(const Frame& frame, const KeyTree<Block>& tree,
                                    Direction direction) const;
  template <class Take>
  void unpackAll(const KeyTree<Block>& tree, Direction direction, const Take& take) const;

  std::string name_;
  FileHead head_;
  Enclosures enclosures_;
  std::vector<Frame> frames_;
};

/// Bytes of a checkpoint, a slice at a time, so that strokes need not wait for it.
template <int Side>
class CheckpointWriter {
 public:
  /// The tree must not change meanwhile.
  CheckpointWriter(const FileHead& head, const KeyTree<CornerBlock<Side>>& tree,
                   const Beside& beside = {});
  /// The next bytes of the file; empty when all have been given.
  Bytes next();

 private:
  const KeyTree<CornerBlock<Side>>* tree_;
  typename KeyTree<CornerBlock<Side>>::const_iterator node_;
  Bytes head_;
  std::uint64_t mark_;
  std::uint32_t frames_ = 0;
  bool ended_ = false;
};

}  // namespace bozzetto::undo
