// The working set of a step: the clay in a box of tiles, as plain arrays, so that kernels run over
// long rows with constant strides. Only rows of tiles that hold clay, and their neighbours, are
// visited. The outermost tiles are the rim: what they hold is seen, and never moves.
//
// Values are multiples of 2⁻²⁰ below 16: sums and differences of them are exact in float, so what
// is taken from one cell and given to another is conserved to the last bit, in any order.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "bozzetto/base/parallel.hpp"
#include "bozzetto/base/simd.hpp"
#include "bozzetto/grid/key.hpp"
#include "clay/cells.hpp"

namespace bozzetto::clay {

/// The nearest multiple of 2⁻²⁰, for |x| < 4.
BOZZETTO_KERNEL float quantised(float x) { return (x + 12.0f) - 12.0f; }
inline constexpr float kQuantum = 0x1p-20f;

/// Cells that hold less have no clay as far as distances and seeds are concerned (clay.md §3.1).
inline constexpr float kThin = 0.01f;
inline constexpr std::uint8_t kFixed = 255;
/// Painted stiffness in a region: this much above or below is as much as there can be.
inline constexpr float kNoOffset = 127;

/// No cell is filled beyond this: where nothing gives way, matter stays where it is.
inline constexpr float kMostDensity = 15;

/// `count` cells from local (i, j, k) upwards along k.
struct Row {
  std::size_t base;
  std::int32_t i, j, k, count;
};

/// Tiles of 8³ in a row along k, from local tile (i, j, k) upwards.
struct TileRun {
  std::int32_t i, j, k, count;
};

/// Cells of a tool among the eight from `first`, a bit each.
struct CoveredRow {
  std::uint32_t first;
  std::uint8_t cells;
};

/// What a cell is to the projection.
enum class CellType : std::uint8_t { air = 0, clay = 1, closed = 2, gripped = 3 };

/// Nobody, the static tools, moving tool n as kMoving + n, or the rim.
enum Owner : std::uint8_t { kNobody = 0, kStatic = 1, kMoving = 2, kRim = 255 };

class Region {
 public:
  static constexpr int kTile = 8;

  /// `box`: corners, made of whole tiles of 8, two or more tiles of rim included.
  explicit Region(const KeyBox& box);

  const KeyBox& box() const { return box_; }
  /// The box without the rim.
  KeyBox inner() const;
  std::size_t index(Key key) const {
    const Key local = key - box_.low;
    return static_cast<std::size_t>(local.i * strides_[0] + local.j * strides_[1] + local.k);
  }
  Key key(std::size_t index) const {
    const auto n = static_cast<std::uint32_t>(index);
    const auto slab = static_cast<std::uint32_t>(strides_[0]),
               row = static_cast<std::uint32_t>(strides_[1]);
    const std::uint32_t inSlab = n % slab;
    return box_.low + Key{static_cast<std::int32_t>(n / slab),
                          static_cast<std::int32_t>(inSlab / row),
                          static_cast<std::int32_t>(inSlab % row)};
  }
  /// A number of the tile of this cell, less than tileCount().
  std::uint32_t tileOf(std::size_t cell) const;
  std::size_t tileCount() const { return flags_.size(); }
  /// Steps to the next cell along each axis.
  const std::array<std::ptrdiff_t, 3>& strides() const { return strides_; }
  /// Steps to the six neighbours: +i, −i, +j, −j, +k, −k.
  const std::array<std::ptrdiff_t, 6>& neighbours() const { return neighbours_; }

  /// How freely clay moves, 0 … 1.
  float freedom(std::size_t cell) const { return fade ? fade[cell] : 1.0f; }
  /// Of painted stiffness, −1 … 1; only where it is stiffened.
  float offset(std::size_t cell) const {
    return (carried.back()[cell] - kNoOffset) * (1 / kNoOffset);
  }

  /// Looks where clay is now and lists the rows: at tiles that were touched or, after touchRows(),
  /// at all that were listed too; matter moves less than a tile between two calls, or is told by
  /// touch().
  void refreshRows();
  /// This cell has changed. Not for several threads at once.
  void touch(std::size_t cell);
  /// Any cell of the rows may have changed.
  void touchRows() { touchedRows_ = true; }
  /// Rows of tiles with clay and of their 26 neighbours, the rim left out.
  const std::vector<Row>& rows() const { return rows_; }
  /// Rows of tiles with cells of half a cell's clay or more.
  const std::vector<Row>& denseRows() const { return denseRows_; }
  /// Rows but those of deep tiles, in which, and round which, every cell has half or more and no
  /// tool is: nothing of the surface happens there.
  const std::vector<Row>& bandRows() const { return bandRows_; }
  const std::vector<Row>& deepRows() const { return deepRows_; }
  const std::vector<TileRun>& denseTiles() const { return denseTiles_; }
  bool inBand(std::size_t cell) const;
  /// A tool is in the tile of this cell: it, and those round it, are in the band from now on.
  void enterBand(std::size_t cell);
  /// Lists band and deep rows anew once all tools have been painted.
  void listBand();
  /// Clay stands in a tile beside the rim.
  bool reachesRim() const { return reachesRim_; }
  std::int64_t clayCells() const { return clayCells_; }
  /// Of the tiles with clay, the rim left out; empty where there is none.
  const KeyBox& clayBox() const { return clayBox_; }

  /// First corners of tiles that may have changed since the last call: what may differ from the
  /// tree.
  std::vector<Key> takeChanged();
  bool inRim(Key key) const;

  /// Moves matter, and what it carries, between two cells. Exact for multiples of 2⁻²⁰.
  void carry(std::size_t from, std::size_t to, float amount) {
    const float sum = value[to] + amount;
    if (sum > 0)
      for (auto& channel : carried) channel[to] += (channel[from] - channel[to]) * (amount / sum);
    value[to] = sum;
    value[from] -= amount;
  }

  Cells<float> value, cover, pressure, pressureNext, rhs, inverse, flux, scratch, scratch2;
  std::array<Cells<float>, 3> wish;  ///< displacement of cells
  std::array<Cells<float>, 3> face;  ///< displacement at faces to the next cell
  /// What travels with matter, 0 … 255: red, green and blue where there is more than one colour,
  /// then painted stiffness, kNoOffset where there is none.
  std::vector<Cells<float>> carried;
  bool colourful = false, stiffened = false;  ///< which of these there are
  Cells<float> fade;                          ///< freedom towards the rim; empty: 1
  Cells<std::uint8_t> hold, owner, type, mark, mark2;
  std::vector<CoveredRow> covered;  ///< cells that tools cover, static ones first
  std::uint32_t onlyColour = 0;     ///< attributes without hold
  bool clayInRim = false;           ///< clay goes on beyond the region
  bool wished = false;              ///< a layer has asked for a displacement not yet carried out

 private:
  struct Tiles {
    std::int32_t i, j, k;
  };
  /// Which tiles a list takes: those whose flags are `wanted` under `mask`.
  struct Selection {
    std::uint16_t mask, wanted;
  };
  std::size_t tileIndex(std::int32_t i, std::int32_t j, std::int32_t k) const;
  std::array<std::uint32_t, 27> around(std::uint32_t tile) const;
  void closeRim();
  bool lookAt(std::uint32_t tile);
  void list();
  void classify(std::uint32_t tile);
  void clear(std::size_t tile);
  template <class Callback>
  void forRowsOfTile(std::size_t tile, const Callback& callback) const;
  Key firstOf(std::uint32_t tile) const;
  void listTiles(Selection which, std::vector<TileRun>& runs) const;
  void listRows(const std::vector<TileRun>& runs, std::vector<Row>& rows) const;
  void listRows(Selection which, std::vector<Row>& rows);

  KeyBox box_;
  Tiles tiles_;
  std::array<std::ptrdiff_t, 3> strides_;
  std::array<std::ptrdiff_t, 6> neighbours_;
  std::vector<std::uint16_t> flags_;
  std::vector<std::uint32_t> listed_, touched_, changed_, before_, tooled_;
  std::vector<std::int32_t> countOf_;
  std::vector<TileRun> denseTiles_, runs_;
  std::vector<Row> rows_, denseRows_, bandRows_, deepRows_;
  bool touchedRows_ = false, reachesRim_ = false;
  std::int64_t clayCells_ = 0;
  KeyBox clayBox_;
};

/// A cell of which tools take so much, or more, is closed.
inline constexpr float kClosedCover = 0.5f;
/// Held, or half or more of it is a tool's or a support's: walking matter does not cross it, and no
/// surface is faired there.
inline bool isClosed(const Region& region, std::size_t cell) {
  return region.hold[cell] == kFixed || region.cover[cell] >= kClosedCover;
}
/// Not held, and both in what moves or both in what stands still: the way out of one may cross the
/// other.
inline bool isOfSameKind(const Region& region, std::size_t cell, std::size_t other) {
  return region.hold[cell] != kFixed &&
         (region.owner[cell] == kStatic) == (region.owner[other] == kStatic);
}

/// The box of whole tiles that holds `box` and `rim` more tiles on every side.
KeyBox tileBox(const KeyBox& box, std::int32_t rim);

/// Runs body(row) for all rows, in parallel where there is enough to do.
template <class Body>
void forRows(const std::vector<Row>& rows, const Body& body) {
  if (rows.empty()) return;
  constexpr std::size_t cellsAThread = 16384;
  const auto mean = static_cast<std::size_t>(rows[rows.size() / 2].count);
  parallelFor(rows.size(), cellsAThread / mean + 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) body(rows[n]);
  });
}

}  // namespace bozzetto::clay
