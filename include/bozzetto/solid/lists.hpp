// Many short lists of numbers in two arrays: loops of faces, faces of cells, neighbours.
#pragma once
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

namespace bozzetto {

/// Number of a point, edge, face or cell of a lattice.
using Id = std::uint32_t;
inline constexpr Id kNoId = ~Id{0};

class Lists {
 public:
  std::size_t size() const { return start_.size() - 1; }
  std::span<const Id> operator[](std::size_t n) const {
    return std::span(items_).subspan(start_[n], start_[n + 1] - start_[n]);
  }
  std::span<Id> at(std::size_t n) {
    return std::span(items_).subspan(start_[n], start_[n + 1] - start_[n]);
  }
  /// Where list n begins among all items.
  std::size_t startOf(std::size_t n) const { return start_[n]; }
  std::size_t itemCount() const { return items_.size(); }
  std::span<const Id> items() const { return items_; }

  void add(std::span<const Id> list) {
    items_.insert(items_.end(), list.begin(), list.end());
    start_.push_back(static_cast<Id>(items_.size()));
  }
  void add(std::initializer_list<Id> list) { add(std::span(list.begin(), list.size())); }

  /// Every list n holds those m, in rising order, whose list in `other` holds n. O(items).
  static Lists inverse(const Lists& other, std::size_t count) {
    Lists result;
    result.start_.assign(count + 1, 0);
    for (const Id n : other.items_) ++result.start_[n + 1];
    for (std::size_t n = 0; n < count; ++n) result.start_[n + 1] += result.start_[n];
    std::vector<Id> next(result.start_.begin(), result.start_.end() - 1);
    result.items_.resize(other.items_.size());
    for (Id m = 0; m < other.size(); ++m)
      for (const Id n : other[m]) result.items_[next[n]++] = m;
    return result;
  }

  friend bool operator==(const Lists&, const Lists&) = default;

 private:
  std::vector<Id> start_{0};
  std::vector<Id> items_;
};

}  // namespace bozzetto
