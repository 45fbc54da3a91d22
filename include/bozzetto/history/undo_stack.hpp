// Undo and redo in memory: deltas in a row and a place among them. Knows blocks, not tools. Undo
// puts block pointers back, so its cost is the changed blocks' tree paths, whatever made them.
#pragma once
#include <cassert>
#include <cstddef>
#include <vector>

#include "bozzetto/grid/delta.hpp"

namespace bozzetto {

/// `Note` is what the owner wants to know about a step (label, scale …); history never looks in.
template <class Block, class Note>
class UndoStack {
 public:
  struct Step {
    Delta<Block> delta;
    Note note;
  };

  /// Adds a step after the current place; steps that had been undone are forgotten.
  void push(Delta<Block> delta, Note note) {
    steps_.resize(done_);
    steps_.push_back({std::move(delta), std::move(note)});
    ++done_;
  }

  bool canUndo() const { return done_ > 0; }
  bool canRedo() const { return done_ < steps_.size(); }

  /// Takes the last step back from the tree and returns it. Needs canUndo().
  const Step& undo(KeyTree<Block>& tree) {
    assert(canUndo());
    const Step& step = steps_[--done_];
    step.delta.apply(tree, Direction::backward);
    return step;
  }

  /// Does the next step again and returns it. Needs canRedo().
  const Step& redo(KeyTree<Block>& tree) {
    assert(canRedo());
    const Step& step = steps_[done_++];
    step.delta.apply(tree, Direction::forward);
    return step;
  }

  /// Steps that undo would take back.
  std::size_t undoDepth() const { return done_; }
  std::size_t redoDepth() const { return steps_.size() - done_; }
  const std::vector<Step>& steps() const { return steps_; }

  void clear() {
    steps_.clear();
    done_ = 0;
  }

 private:
  std::vector<Step> steps_;
  std::size_t done_ = 0;
};

}  // namespace bozzetto
