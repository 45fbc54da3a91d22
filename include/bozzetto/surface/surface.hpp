// The surface of a field, kept up to date edit by edit: marching cubes over blocks (Ferley §3.1
// and §3.2). One patch per block of cubes that the surface crosses, in a balanced tree.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bozzetto/field/changed_run.hpp"
#include "bozzetto/field/field.hpp"
#include "bozzetto/surface/patch.hpp"

namespace bozzetto {

struct TouchedRun;

/// What one refresh did.
struct RefreshReport {
  std::size_t examined = 0;   ///< blocks of cubes whose corners' range was looked at
  std::size_t meshed = 0;     ///< of these, blocks that the surface crosses
  std::size_t crossing = 0;   ///< crossing cubes in the meshed blocks
  std::size_t vertices = 0;   ///< owned by the meshed blocks: crossing edges
  std::size_t triangles = 0;  ///< in the meshed blocks
  std::vector<Key> changed;   ///< patches made, altered or gone, ascending
};

/// What all patches hold together.
struct SurfaceTotals {
  std::int64_t patches = 0, crossingCubes = 0, edges = 0, triangles = 0;
  friend bool operator==(const SurfaceTotals&, const SurfaceTotals&) = default;
};

/// After any sequence of refreshes the patches equal those of a rebuild, bit for bit, for any
/// number of threads. Not thread-safe itself; patches held through a Ref may be read meanwhile.
template <int Side>
class Surface {
 public:
  using FieldType = Field<Side>;
  using Block = CornerBlock<Side>;
  using Patches = KeyTree<SurfacePatch>;

  /// Everything anew. O(blocks near the surface + nodes).
  RefreshReport rebuild(const FieldType& field);

  /// After the corners in the `changed` blocks (sorted, not overlapping) took their present
  /// values. O(changed blocks and the neighbours they touch). A new iso rebuilds.
  RefreshReport refresh(const FieldType& field, std::span<const KeyRun> changed);

  /// The same where it is known which corners changed: leaves out neighbours that none of them is
  /// felt in. What a dab reports.
  RefreshReport refresh(const FieldType& field, std::span<const ChangedRun> changed);

  /// The same from a delta that was just applied, in either direction: compares the corners and
  /// leaves out neighbours that no changed corner is felt in.
  RefreshReport refresh(const FieldType& field, const Delta<Block>& delta);

  const Patches& patches() const { return patches_; }
  const SurfaceTotals& totals() const { return totals_; }
  float iso() const { return iso_; }

  /// Bytes of patches and tree.
  std::size_t bytes() const;

  /// The first broken promise, if any: sums, orders, indices, neighbours that do not meet.
  std::optional<std::string> validate() const;

 private:
  struct Work;
  class Sweep;

  RefreshReport refreshTouched(const FieldType& field, std::vector<TouchedRun> touched);
  RefreshReport run(const Work& work);
  void apply(Sweep& sweep);

  Patches patches_;
  SurfaceTotals totals_;
  float iso_ = 0;
};

extern template class Surface<1>;
extern template class Surface<8>;

/// The corners whose value or attributes a delta changed. O(corners of the changed blocks).
template <int Side>
std::vector<ChangedRun> changedRuns(const Delta<CornerBlock<Side>>& delta);

/// Cubes that share a changed corner: the paper's "treated" cubes. `changed` is sorted and does not
/// overlap. O(changed blocks).
template <int Side>
std::int64_t treatedCubes(std::span<const ChangedRun> changed);

}  // namespace bozzetto
