// Lines of full cells, through which matter walks without finding anything: many walk along the
// same ones, and each is looked at once.
#pragma once
#include <array>

#include "clay/region.hpp"

namespace bozzetto::clay {

/// Open, and without room for a quantum.
inline bool isFull(const Region& region, std::size_t cell) {
  const float room = (1 - region.cover[cell]) - region.value[cell];
  return !isClosed(region, cell) && room < kQuantum;
}

class FullLines {
 public:
  struct Way {
    std::size_t axis;
    int sign;
  };
  /// Forgets what it knows. What is full stays so while matter only walks: cells that receive are
  /// not, and those that give keep all they have room for.
  void begin(const Region& region);
  /// How many full cells follow on this one, `most` at most.
  int ahead(const Region& region, std::size_t cell, Way way, int most);

 private:
  struct Known {
    std::int32_t from = 0, to = -1;  // along the line
  };
  std::array<std::vector<Known>, 3> lines_;  // along each axis
  std::vector<Known*> touched_;
};

}  // namespace bozzetto::clay
