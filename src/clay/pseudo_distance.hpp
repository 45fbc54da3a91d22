// Pseudo-distances through clay (Dewaele §3.1): what a tool's lead has to travel. Entering a cell
// costs more where there is less clay, so that weak points tear first.
#pragma once
#include <limits>

#include "clay/pieces.hpp"

namespace bozzetto::clay {

inline constexpr float kFar = std::numeric_limits<float>::infinity();
inline constexpr float kMostCost = 100;

/// The shortest way from one tool to another within one piece.
struct Contact {
  std::uint32_t piece;
  std::uint8_t owner;  ///< of the cells reached
  float distance;
};

class PseudoDistance {
 public:
  /// From the cells of `owner` (kStatic includes held cells) over 6-neighbours with clay, stopping
  /// at cells of other owners. `cost` ≥ 1 of entering a cell. Fills `distance` in the region's
  /// rows; kFar where no way leads. O(cells reached).
  void run(const Region& region, std::uint8_t owner, const Cells<float>& cost,
           Cells<float>& distance);
  /// The first contacts of the last run, one a piece and owner.
  std::vector<Contact> contacts(const Pieces& pieces) const;

 private:
  static constexpr std::size_t kBuckets = 256;
  void sow(const Region& region, std::uint8_t owner, Cells<float>& distance);

  struct Touch {
    std::uint32_t cell;
    std::uint8_t owner;
    float distance;
  };
  std::vector<std::uint32_t> bucket_[kBuckets];
  std::vector<Touch> touches_;
};

/// Whose cell it is: held cells belong to the static tools.
inline std::uint8_t ownerOf(const Region& region, std::size_t cell) {
  if (region.hold[cell] == kFixed && region.owner[cell] != kRim) return kStatic;
  return region.owner[cell];
}

}  // namespace bozzetto::clay
