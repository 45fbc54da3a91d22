// The inside of a History: what is held, what is written, what may go.
#pragma once
#include <map>
#include <random>

#include "history/delta_cache.hpp"
#include "history/history_parts.hpp"

namespace bozzetto {

template <int Side>
struct History<Side>::State {
  explicit State(HistoryParts<Side> from) : parts(std::move(from)) {}

  HistoryParts<Side> parts;
  undo::DeltaCache<Side> cache;
  std::map<StepNumber, Bytes> packed;  // undo-files in memory, where there is no folder
  std::size_t packedBytes = 0;
  std::map<StepNumber, Bytes> pictures;  // where nothing is written
  std::mt19937_64 random{std::random_device{}()};

  bool checkpointRunning = false;
  std::size_t stepsSinceAnchor = 0;
  std::uint64_t bytesSinceAnchor = 0;

  HistoryPlace now() const;
  Step newStep(const Delta<Block>& delta, StepNote note);
  using Change = undo::StepChange<Side>;
  Change changeOf(const StepTree::Leg& leg, const Tree& clay, const Beside& beside);
  Bytes bytesOf(StepNumber step) const;

  /// Calls take(leg, delta) for every leg; the step that could not be read, 0 when all could.
  /// `beside` goes along.
  template <class Take>
  StepNumber walk(const std::vector<StepTree::Leg>& legs, const Tree& clay, Beside& beside,
                  std::string& trouble, const Take& take);
  void cutOff(StepNumber lost);

  void takeNews();
  void makeRoom();
  void rotate();
  void requestCheckpoint();
  bool overLimits() const;
  bool anchoredWithout(StepNumber state) const;
  void dropStep(StepNumber number);
  void dropAnchor(StepNumber state);
  void removeStep(StepNumber step);
  void forget(StepNumber step);
  void letGo(Change change);
  void shrinkMemory();
  bool packOldest();
  std::size_t memoryBytes() const { return cache.bytes() + packedBytes; }
};

}  // namespace bozzetto
