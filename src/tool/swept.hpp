// Where the tool of a stroke has been: its stamps raise no clay in their own trench.
#pragma once
#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <utility>

#include "bozzetto/field/corner_block.hpp"
#include "bozzetto/grid/ref.hpp"

namespace bozzetto {

/// The most that each corner of a block was the tool's, 0…1, over the dabs so far.
template <int Side>
class SweptBlock {
 public:
  static constexpr int kCount = CornerBlock<Side>::kCount;
  using Shares = std::array<float, kCount>;

  /// The block as it was before the stroke, null where there was none; told before it is written.
  void note(const CornerBlock<Side>* block) {
    if (std::exchange(noted_, true) || block == nullptr) return;
    before_ = Ref<CornerBlock<Side>>(const_cast<CornerBlock<Side>*>(block));  // held, not written
  }
  /// That, or what is there now.
  const CornerBlock<Side>* before(const CornerBlock<Side>* now) const {
    return noted_ ? before_.get() : now;
  }

  /// Of its corners, 64-byte aligned or not; valid until the next add.
  const float* shares() const { return shares_ ? shares_->data() : all_ ? alike<1>() : alike<0>(); }
  /// One dab more.
  void add(const float* body) {
    if (all_) return;
    const float* old = shares();
    const auto grows = [&](int n) { return body[n] > old[n]; };
    int n = 0;
    while (n < kCount && !grows(n)) ++n;
    if (n == kCount) return;
    if (!shares_) shares_ = std::make_unique<Shares>();
    for (; n < kCount; ++n) {
      const auto at = static_cast<std::size_t>(n);
      (*shares_)[at] = std::max((*shares_)[at], body[n]);
    }
    all_ = std::ranges::all_of(*shares_, [](float share) { return share >= 1; });
    if (all_) shares_.reset();
  }

 private:
  template <int kShare>
  static const float* alike() {
    static const auto* const shares = [] {
      auto* made = new Shares;
      made->fill(float{kShare});
      return made;
    }();
    return shares->data();
  }

  std::unique_ptr<Shares> shares_;
  Ref<CornerBlock<Side>> before_;
  bool noted_ = false;
  bool all_ = false;  // all corners are 1
};

/// Blocks by their keys. Entries stay where they are.
template <int Side>
using Swept = std::map<Key, SweptBlock<Side>>;

/// That nothing was there.
template <int Side>
const SweptBlock<Side>& unswept() {
  static const auto* const block = new SweptBlock<Side>();
  return *block;
}

}  // namespace bozzetto
