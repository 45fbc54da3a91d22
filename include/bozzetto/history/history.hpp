// The history of a document: every step that changed clay or what is beside it, undone ones and
// branches too. Recent steps are pointers to blocks; older ones are undo-files on the disk (Ferley
// §3.3), or their bytes in memory where there is no folder. The undo-files are the journal as well.
//
// Not for use by several threads at once. Handing over a step costs O(changed blocks) pointers;
// a thread of its own writes it.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bozzetto/base/bytes.hpp"
#include "bozzetto/base/file_system.hpp"
#include "bozzetto/history/beside.hpp"
#include "bozzetto/history/step_tree.hpp"

namespace bozzetto {

struct HistoryLimits {
  std::size_t steps = 200;      ///< undo-files kept in a folder; 0: any number
  std::uint64_t diskBytes = 0;  ///< of undo-files; 0: any number
  std::size_t memoryBytes = 256u << 20;
};

template <int Side>
struct HistoryParts;

template <int Side>
class History {
 public:
  using Block = CornerBlock<Side>;
  using Tree = KeyTree<Block>;
  using DeltaPointer = std::shared_ptr<const Delta<Block>>;

  /// One in memory only.
  explicit History(HistoryLimits limits = {});
  /// From openHistory.
  explicit History(HistoryParts<Side> parts);
  History(History&&) noexcept;
  History& operator=(History&&) noexcept;
  ~History();

  /// A step from where we are to what clay and the rest are now; we are there then. A step after
  /// undo begins a branch; the old one stays. `thumbnail`: a PNG, or empty.
  StepNumber push(DeltaPointer delta, StepNote note, Beside beside = {}, Bytes thumbnail = {});

  /// What stands beside the clay where we are.
  const Beside& beside() const;
  const SolidRef& solid() const { return beside().solid; }
  /// What there was before all steps.
  void place(Beside beside);

  const StepTree& tree() const;
  StepNumber place() const { return tree().place(); }
  std::size_t undoDepth() const { return tree().undoDepth(); }
  std::size_t redoDepth() const { return tree().redoDepth(); }
  /// All steps in the order in which they were made.
  std::vector<Step> steps() const;
  /// A step's picture, or nothing.
  Bytes thumbnail(StepNumber step) const;
  /// A picture that was made when there was time, after the step. It lies beside the undo-file and
  /// may be lost where that may not; unknown steps have none.
  void setThumbnail(StepNumber step, Bytes png);

  /// What a walk through the tree did.
  struct Journey {
    DeltaPointer delta;   ///< what differs in the clay now; each block once
    FieldScale scale;     ///< of the clay now
    std::string trouble;  ///< empty, or why it ended early: a step was lost and is cut off
  };
  /// Brings clay and the rest to another state and goes there. Costs the blocks of the steps
  /// between. Throws Error for a state that is not in the tree.
  Journey goTo(StepNumber state, Tree& clay, const FieldScale& scale);

  /// The clay of another state; `clay` is that of this place, and stays. Throws Error for states
  /// that are not in the tree or cannot be read any more.
  Field<Side> fieldAt(StepNumber state, const Field<Side>& clay);

  /// Bytes of blocks and packed steps held in memory; blocks that the clay has too are counted.
  std::size_t memoryBytes() const;

  // On the disk.

  /// Whether steps are written.
  bool onDisk() const;
  /// Where undo-files are; empty in memory.
  std::filesystem::path folder() const;
  /// What a document that is saved now should remember.
  HistoryPlace savePlace() const;
  /// The document on the disk holds this place now: recovery can start from it.
  void markSaved(const HistoryPlace& place);
  /// The state that the document on the disk has, where it can still be reached.
  std::optional<StepNumber> savedState() const;
  /// Whether we are where the document on the disk is.
  bool atSaved() const { return savedState() == place(); }
  /// Counts steps and moves.
  std::uint64_t moment() const;
  /// All up to this moment is on the disk, synced. In memory: 0.
  std::uint64_t durableMoment() const;
  /// Returns when everything is on the disk. Throws Error when the disk does not take it; nothing
  /// is lost in memory then, and the next step tries again.
  void waitDurable();
  /// Why the disk does not take what waits; empty when all is well.
  std::string trouble() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

extern template class History<1>;
extern template class History<8>;

}  // namespace bozzetto
