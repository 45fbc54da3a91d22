// What distinguishes two states of a sculpture: for people who compare steps of its history.
#pragma once
#include <cstdint>
#include <vector>

#include "bozzetto/field/field.hpp"

namespace bozzetto {

struct FieldDifference {
  std::int64_t blocks = 0;               ///< places whose block is another
  std::int64_t corners = 0;              ///< whose value or attributes differ
  std::int64_t reshaped = 0;             ///< of these, whose value differs
  KeyBox bounds;                         ///< of the corners that differ
  double massBefore = 0, massAfter = 0;  ///< world units
};

/// Looks only at blocks that the two do not share: O(nodes) pointers and the corners of those.
/// Corners are compared by their keys, whatever the spacings. Committed fields only.
template <int Side>
FieldDifference compare(const Field<Side>& before, const Field<Side>& after);

/// The places that `compare` counts, ascending: what turns one surface into the other.
template <int Side>
std::vector<KeyRun> differingBlocks(const Field<Side>& before, const Field<Side>& after);

extern template std::vector<KeyRun> differingBlocks(const Field<1>&, const Field<1>&);
extern template std::vector<KeyRun> differingBlocks(const Field<8>&, const Field<8>&);
extern template FieldDifference compare(const Field<1>&, const Field<1>&);
extern template FieldDifference compare(const Field<8>&, const Field<8>&);

}  // namespace bozzetto
