// What lacks inside the clay is made good by the clay round about: Margolus blocks whose cells clay
// is all round of even out what they hold.
#pragma once
#include <vector>

#include "clay/region.hpp"

namespace bozzetto::clay {

/// Clay that is not held, with clay on all six sides and no tool in it.
bool isInside(const Region& region, std::size_t cell);

class Evening {
 public:
  /// So many sweeps over the tiles in which something lacks. Clay inside does not fall below a
  /// half, the surface stays where it is. Exact. O(dense rows + tiles that lack · sweeps).
  void run(Region& region, int sweeps);

 private:
  void listLacking(const Region& region);
  void markInside(Region& region);
  void forget(Region& region);
  void sweep(Region& region, int parity);

  std::vector<Key> tiles_;  // with cells inside that lack, and their neighbours
};

}  // namespace bozzetto::clay
