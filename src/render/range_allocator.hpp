// Places inside one growing buffer: first fit, neighbours joined when freed.
#pragma once
#include <cstddef>
#include <map>

namespace bozzetto {

class RangeAllocator {
 public:
  /// Start of `count` free elements; what lies beyond size() afterwards is new.
  std::size_t take(std::size_t count);
  void free(std::size_t start, std::size_t count);
  /// One past the last element ever needed at once.
  std::size_t size() const { return size_; }

 private:
  std::map<std::size_t, std::size_t> free_;  // start → count
  std::size_t size_ = 0;
};

}  // namespace bozzetto
