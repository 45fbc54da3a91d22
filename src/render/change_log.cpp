#include "render/change_log.hpp"

namespace bozzetto {

void ChangeLog::note(const CellBounds& box) {
  if (box.empty()) return;
  if (boxes_.size() >= kMost) noteAll();
  boxes_.push_back(box);
}

void ChangeLog::noteAll() {
  first_ = now() + 1;
  boxes_.clear();
}

std::optional<std::span<const CellBounds>> ChangeLog::since(std::uint64_t then) const {
  if (then < first_) return std::nullopt;
  return std::span(boxes_).subspan(std::size_t(then - first_));
}

}  // namespace bozzetto
