#include "bozzetto/history/step_tree.hpp"

#include <algorithm>
#include <cassert>
#include <cstdio>
#include <set>

namespace bozzetto {

std::string HistoryPlace::text() const {
  char buffer[80];
  std::snprintf(buffer, sizeof buffer, "%u %u %016llx %llu", place, tip,
                static_cast<unsigned long long>(mark), static_cast<unsigned long long>(moment));
  return buffer;
}

std::optional<HistoryPlace> HistoryPlace::parse(const std::string& text) {
  HistoryPlace result;
  unsigned long long mark = 0, moment = 0;
  if (std::sscanf(text.c_str(), "%u %u %llx %llu", &result.place, &result.tip, &mark, &moment) != 4)
    return std::nullopt;
  result.mark = mark;
  result.moment = moment;
  if (result.text() != text) return std::nullopt;
  return result;
}

std::uint64_t StepTree::markOf(StepNumber state) const {
  const Step* step = find(state);
  return step == nullptr ? rootMark_ : step->mark;
}

const Step* StepTree::find(StepNumber number) const {
  const auto node = nodes_.find(number);
  return node == nodes_.end() ? nullptr : &node->second.step;
}

std::vector<Step> StepTree::steps() const {
  std::vector<Step> steps;
  steps.reserve(nodes_.size());
  for (const auto& [number, node] : nodes_) steps.push_back(node.step);
  return steps;
}

std::size_t StepTree::depthOf(StepNumber state) const {
  return state == root_ ? rootDepth_ : nodes_.at(state).depth;
}

std::size_t StepTree::undoDepth() const { return depthOf(place_) - rootDepth_; }
std::size_t StepTree::redoDepth() const { return depthOf(tip_) - depthOf(place_); }

StepNumber StepTree::undoTarget(std::size_t count) const {
  StepNumber state = place_;
  for (; count > 0 && state != root_; --count) state = find(state)->parent;
  return state;
}

StepNumber StepTree::redoTarget(std::size_t count) const {
  StepNumber state = place_;
  for (; count > 0 && nextOf(state) != 0; --count) state = nextOf(state);
  return state;
}

// A parent has a smaller number than its children: of two states the larger number goes up.
std::vector<StepTree::Leg> StepTree::path(StepNumber from, StepNumber to) const {
  std::vector<Leg> up, down;
  while (from != to) {
    if (from > to) {
      up.push_back({from, Direction::backward});
      from = find(from)->parent;
    } else {
      down.push_back({to, Direction::forward});
      to = find(to)->parent;
    }
  }
  up.insert(up.end(), down.rbegin(), down.rend());
  return up;
}

void StepTree::add(Step step) {
  assert(has(step.parent) && (nodes_.empty() || step.number > nodes_.rbegin()->first));
  const StepNumber number = step.number, parent = step.parent;
  (parent == root_ ? rootChildren_ : nodes_.at(parent).children).push_back(number);
  writtenBytes_ += step.bytes;
  Node& node = nodes_[number];
  node.step = std::move(step);
  node.depth = depthOf(parent) + 1;
}

void StepTree::moveTo(StepNumber state) {
  bool newWay = false;
  for (const Leg& leg : path(place_, state)) {
    const StepNumber parent = find(leg.step)->parent;
    newWay |= leg.direction == Direction::forward && nextOf(parent) != leg.step;
    nextLink(parent) = leg.step;
  }
  place_ = state;
  if (newWay || childrenOf(place_).empty()) tip_ = endOfChain(place_);
}

void StepTree::aimAt(StepNumber tip) {
  if (!has(tip)) tip = place_;
  StepNumber state = tip;
  while (state > place_) state = find(state)->parent;
  if (state == place_) {
    for (StepNumber child = tip; child > place_; child = find(child)->parent) {
      nextLink(find(child)->parent) = child;
    }
  }
  tip_ = endOfChain(place_);
}

void StepTree::noteWritten(StepNumber number, std::uint64_t corners, std::uint64_t bytes) {
  const auto node = nodes_.find(number);
  if (node == nodes_.end()) return;
  writtenBytes_ += bytes - node->second.step.bytes;
  node->second.step.changedCorners = corners;
  node->second.step.bytes = bytes;
}

std::optional<StepNumber> StepTree::nextToDrop() const {
  for (const auto& [number, node] : nodes_) {
    if (isEnd(number)) return number;
  }
  return std::nullopt;
}

// One of its two states has no other step, and we are not there.
bool StepTree::isEnd(StepNumber number) const {
  if (number != place_ && childrenOf(number).empty()) return true;
  return find(number)->parent == root_ && rootChildren_.size() == 1 && root_ != place_;
}

StepNumber StepTree::stateThatGoesWith(StepNumber number) const {
  return number != place_ && childrenOf(number).empty() ? number : root_;
}

StepNumber StepTree::drop(StepNumber number) {
  assert(isEnd(number));
  Node& node = nodes_.at(number);
  if (stateThatGoesWith(number) == number) {
    forgetChild(node.step.parent, number);
    erase(number);
    if (tip_ == number) tip_ = endOfChain(place_);
    return number;
  }
  const StepNumber gone = root_;
  root_ = number;
  rootMark_ = node.step.mark;
  rootChildren_ = std::move(node.children);
  rootNext_ = node.next;
  rootDepth_ = node.depth;
  erase(number);
  return gone;
}

std::vector<StepNumber> StepTree::cut(StepNumber number) {
  std::vector<StepNumber> gone;
  // What lies beyond: below the step when we are above it, else all the rest.
  std::set<StepNumber> below{number};
  for (const auto& [other, node] : nodes_) {
    if (below.contains(node.step.parent)) below.insert(other);
  }
  const bool weAreBelow = below.contains(place_);
  if (weAreBelow) {
    const Node top = nodes_.at(number);
    for (const auto& [other, node] : nodes_) {
      if (other == number || !below.contains(other)) gone.push_back(other);
    }
    root_ = number;
    rootMark_ = top.step.mark;
    rootChildren_ = top.children;
    rootNext_ = top.next;
    rootDepth_ = top.depth;
  } else {
    gone.assign(below.begin(), below.end());
    forgetChild(nodes_.at(number).step.parent, number);
  }
  for (const StepNumber each : gone) erase(each);
  tip_ = endOfChain(place_);
  return gone;
}

std::optional<std::string> StepTree::validate() const {
  if (!has(place_) || !has(tip_)) return "place or tip unknown";
  if (endOfChain(place_) != tip_) return "redo does not lead to the tip";
  std::size_t children = rootChildren_.size();
  for (const auto& [number, node] : nodes_) {
    children += node.children.size();
    const auto& siblings = has(node.step.parent) ? childrenOf(node.step.parent) : rootChildren_;
    const bool listed = std::ranges::count(siblings, number) == 1;
    const bool deeper = has(node.step.parent) && node.depth == depthOf(node.step.parent) + 1;
    if (node.step.number != number || node.step.parent >= number || !listed || !deeper)
      return "step " + std::to_string(number) + " is not its parent's child";
  }
  if (children != nodes_.size()) return "children that are no steps";
  return std::nullopt;
}

const std::vector<StepNumber>& StepTree::childrenOf(StepNumber state) const {
  return state == root_ ? rootChildren_ : nodes_.at(state).children;
}

StepNumber& StepTree::nextLink(StepNumber state) {
  return state == root_ ? rootNext_ : nodes_.at(state).next;
}

StepNumber StepTree::nextOf(StepNumber state) const {
  const auto& children = childrenOf(state);
  if (children.empty()) return 0;
  const StepNumber next = state == root_ ? rootNext_ : nodes_.at(state).next;
  return next != 0 ? next : children.back();
}

StepNumber StepTree::endOfChain(StepNumber from) const {
  while (const StepNumber next = nextOf(from)) from = next;
  return from;
}

void StepTree::erase(StepNumber number) {
  writtenBytes_ -= nodes_.at(number).step.bytes;
  nodes_.erase(number);
}

void StepTree::forgetChild(StepNumber parent, StepNumber child) {
  auto& children = parent == root_ ? rootChildren_ : nodes_.at(parent).children;
  std::erase(children, child);
  if (nextLink(parent) == child) nextLink(parent) = 0;
}

}  // namespace bozzetto
