#include "render/range_allocator.hpp"

#include <iterator>

namespace bozzetto {

std::size_t RangeAllocator::take(std::size_t count) {
  for (auto hole = free_.begin(); hole != free_.end(); ++hole) {
    const auto [start, length] = *hole;
    if (length < count) continue;
    free_.erase(hole);
    if (length > count) free_[start + count] = length - count;
    return start;
  }
  const std::size_t start = size_;
  size_ += count;
  return start;
}

void RangeAllocator::free(std::size_t start, std::size_t count) {
  if (count == 0) return;
  auto hole = free_.emplace(start, count).first;
  const auto after = std::next(hole);
  if (after != free_.end() && start + count == after->first) {
    hole->second += after->second;
    free_.erase(after);
  }
  if (hole == free_.begin()) return;
  const auto before = std::prev(hole);
  if (before->first + before->second == start) {
    before->second += hole->second;
    free_.erase(hole);
  }
}

}  // namespace bozzetto
