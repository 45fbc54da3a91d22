// The tree of steps: which states there are, how one leads to another, where we are, where redo
// leads, and which step is the next to be forgotten. Knows no clay and no files.
#pragma once
#include <map>
#include <optional>
#include <vector>

#include "bozzetto/grid/delta.hpp"
#include "bozzetto/history/step.hpp"

namespace bozzetto {

/// What a saved document, or the journal, remembers of where it was in its history.
struct HistoryPlace {
  StepNumber place = 0;      ///< the state
  StepNumber tip = 0;        ///< where redo leads in the end
  std::uint64_t mark = 0;    ///< of the step that led to the state
  std::uint64_t moment = 0;  ///< counts steps and moves: the larger, the later

  std::string text() const;
  static std::optional<HistoryPlace> parse(const std::string& text);
  friend bool operator==(const HistoryPlace&, const HistoryPlace&) = default;
};

/// States are numbered by the step that leads to them. Always one tree: every state can be reached
/// from every other.
class StepTree {
 public:
  /// Only the state `root`, and there we are.
  explicit StepTree(StepNumber root = 0, std::uint64_t rootMark = 0)
      : root_(root), rootMark_(rootMark), place_(root), tip_(root) {}

  StepNumber root() const { return root_; }
  StepNumber place() const { return place_; }
  StepNumber tip() const { return tip_; }
  std::uint64_t markOf(StepNumber state) const;
  std::size_t size() const { return nodes_.size(); }
  std::uint64_t writtenBytes() const { return writtenBytes_; }  ///< of all undo-files
  bool has(StepNumber state) const { return state == root_ || nodes_.contains(state); }
  /// Null for the root and for unknown states.
  const Step* find(StepNumber number) const;
  std::vector<Step> steps() const;  ///< in the order in which they were made

  /// Steps that undo would take back, and that redo would do again. O(log n).
  std::size_t undoDepth() const;
  std::size_t redoDepth() const;
  /// Where `count` undos, or redos, from here lead; as far as there are any.
  StepNumber undoTarget(std::size_t count) const;
  StepNumber redoTarget(std::size_t count) const;

  struct Leg {
    StepNumber step;
    Direction direction;
  };
  /// The steps between two states, in order. O(their number · log n).
  std::vector<Leg> path(StepNumber from, StepNumber to) const;

  /// A step from a known state, later than all others. Does not move us.
  void add(Step step);
  /// We are there now; redo leads where we were last beyond it.
  void moveTo(StepNumber state);
  /// Where redo leads from here: `tip` if it can be reached downwards, else the newest branch.
  void aimAt(StepNumber tip);
  /// What became known when the step was written.
  void noteWritten(StepNumber number, std::uint64_t corners, std::uint64_t bytes);

  /// The oldest step at an end of the tree where we are not; none when there is no step.
  std::optional<StepNumber> nextToDrop() const;
  /// Which of its two states would go with such a step.
  StepNumber stateThatGoesWith(StepNumber number) const;
  /// Forgets a step at an end of the tree; returns the state that goes with it.
  StepNumber drop(StepNumber number);
  /// Forgets a step and all that can be reached over it only. Returns the steps forgotten.
  std::vector<StepNumber> cut(StepNumber number);

  /// The first broken promise, if any.
  std::optional<std::string> validate() const;

 private:
  struct Node {
    Step step;
    std::vector<StepNumber> children;
    StepNumber next = 0;    // the child that redo takes; 0: the newest
    std::size_t depth = 0;  // steps from where it all began
  };
  std::size_t depthOf(StepNumber state) const;
  const std::vector<StepNumber>& childrenOf(StepNumber state) const;
  StepNumber& nextLink(StepNumber state);
  StepNumber nextOf(StepNumber state) const;
  StepNumber endOfChain(StepNumber from) const;
  bool isEnd(StepNumber number) const;
  void forgetChild(StepNumber parent, StepNumber child);
  void erase(StepNumber number);

  std::map<StepNumber, Node> nodes_;
  StepNumber root_;
  std::uint64_t rootMark_;
  std::vector<StepNumber> rootChildren_;
  StepNumber rootNext_ = 0;
  std::size_t rootDepth_ = 0;
  StepNumber place_, tip_;
  std::uint64_t writtenBytes_ = 0;
};

}  // namespace bozzetto
