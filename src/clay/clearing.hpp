// Tools leave no room: matter inside them moves out, cell by cell, the ways that lead outwards
// (Dewaele §3.2.2), and exactly as much as is too much.
#pragma once
#include "clay/layer.hpp"

namespace bozzetto::clay {

/// More than this times its capacity is too much for a cell (clay.md §4: 1.01 hides matter).
inline constexpr float kTooMuch = 1.002f;
inline constexpr int kClearingSweeps = 64;

class Clearing {
 public:
  /// Jacobi sweeps over the cells that hold too much, at most `sweeps`.
  void run(Work& work, int sweeps = kClearingSweeps);

  /// Directions that matter in a cell of a tool may take: outwards, not into held clay, not into
  /// cells that are deeper; where none is left, any that is not held or deeper.
  std::uint8_t ways(const Work& work, std::size_t cell);
  /// Forgets the ways found since the last call: tools have moved.
  void forget(Region& region);

 private:
  void findExcess(Region& region);
  std::uint8_t waysFrom(const Work& work, std::size_t cell);
  std::uint8_t outwardAt(const Work& work, std::size_t cell);
  std::uint8_t openWays(const Region& region, std::size_t cell) const;
  void give(Region& region, std::size_t cell, std::uint8_t ways);

  std::vector<std::uint32_t> now_, next_, known_;
  std::vector<std::uint8_t> ways_;
  std::vector<float> share_;
};

}  // namespace bozzetto::clay
