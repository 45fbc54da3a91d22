#include "bozzetto/surface/surface.hpp"

#include <algorithm>
#include <mutex>
#include <utility>

#include "bozzetto/base/parallel.hpp"
#include "surface/columns.hpp"
#include "surface/dirty.hpp"
#include "surface/key_runs.hpp"
#include "surface/mesher.hpp"

namespace bozzetto {

/// Blocks of cubes to look at, and the field to look at them in.
template <int Side>
struct Surface<Side>::Work {
  const Columns<Side>& columns;
  const std::vector<KeyRun>& runs;
};

// One thread's share: looks at runs of blocks in order and notes what has to change in the tree.
// Patches that nobody else holds are rewritten where they stand.
template <int Side>
class Surface<Side>::Sweep {
 public:
  using Window = BlockWindow<Side>;
  static constexpr int kSpan = Window::kSpan;
  struct Fresh {
    Key key;
    Ref<SurfacePatch> patch;
    Patches::const_iterator next;  // the patch it goes before
  };

  Sweep(const Surface& surface, const Columns<Side>& columns, std::size_t first)
      : begin(first), surface_(&surface), columns_(&columns) {}

  void look(const KeyRun& run);

  std::size_t begin;
  RefreshReport report;
  SurfaceTotals added, removed;
  std::vector<Fresh> fresh, replaced;
  std::vector<Key> gone;

 private:
  void placeAt(Key key);
  bool crosses(std::int32_t k);
  std::int32_t nextToLookAt(std::int32_t k) const;
  void meshAt(Key key);
  void keep(Key key, const PatchContent& content);
  void dropUntil(Key key);

  const Surface* surface_;
  const Columns<Side>* columns_;
  std::array<ColumnCursor<Side>, kSpan * kSpan> cursors_;
  Key placed_{};
  bool placedOnce_ = false;
  Patches::const_iterator existing_{};
};

namespace {

void addTo(SurfaceTotals& totals, const SurfacePatch& patch) {
  totals.patches += 1;
  totals.crossingCubes += static_cast<std::int64_t>(patch.cubeCount());
  totals.edges += static_cast<std::int64_t>(patch.ownedCount());
  totals.triangles += static_cast<std::int64_t>(patch.triangleCount());
}

void combine(SurfaceTotals& totals, const SurfaceTotals& more, int sign) {
  totals.patches += sign * more.patches;
  totals.crossingCubes += sign * more.crossingCubes;
  totals.edges += sign * more.edges;
  totals.triangles += sign * more.triangles;
}

template <int Side>
Mesher<Side>& mesherOfThread() {
  static thread_local Mesher<Side> mesher;
  return mesher;
}

}  // namespace

template <int Side>
void Surface<Side>::Sweep::look(const KeyRun& run) {
  placeAt(run.key);
  const std::int32_t end = run.key.k + run.length;
  for (std::int32_t k = run.key.k; k < end;) {
    ++report.examined;
    if (crosses(k)) {
      meshAt({run.key.i, run.key.j, k});
      ++k;
    } else {
      k = nextToLookAt(k);
    }
  }
  dropUntil({run.key.i, run.key.j, end});
}

template <int Side>
void Surface<Side>::Sweep::placeAt(Key key) {
  const bool sameColumn = placedOnce_ && key.i == placed_.i && key.j == placed_.j;
  if (!sameColumn) columns_->placeAround(key.i, key.j, cursors_);
  existing_ = surface_->patches_.from(key);
  placed_ = key;
  placedOnce_ = true;
}

// Whether the corners of the blocks that hold the cubes' corners lie on both sides of iso.
template <int Side>
bool Surface<Side>::Sweep::crosses(std::int32_t k) {
  float low = 3e38f, high = -3e38f;
  for (const int column : {kSpan + 1, kSpan + 2, 2 * kSpan + 1, 2 * kSpan + 2}) {
    cursors_[column].moveTo(k);
    for (int n = 1; n <= 2; ++n) {
      const Block& block = *cursors_[column].blocks()[n];
      low = std::min(low, block.low);
      high = std::max(high, block.high);
    }
  }
  return low < surface_->iso_ && high >= surface_->iso_;
}

// Where the blocks stay the same, so does the answer: a step over a whole run.
template <int Side>
std::int32_t Surface<Side>::Sweep::nextToLookAt(std::int32_t k) const {
  std::int32_t until = ColumnCursor<Side>::kNever;
  for (const int column : {kSpan + 1, kSpan + 2, 2 * kSpan + 1, 2 * kSpan + 2}) {
    until = std::min(until, cursors_[column].constantFrom(k + 1));
  }
  return std::max(k + 1, until - 1);
}

template <int Side>
void Surface<Side>::Sweep::meshAt(Key key) {
  Window window;
  for (int column = 0; column < kSpan * kSpan; ++column) {
    cursors_[column].moveTo(key.k);
    const auto& blocks = cursors_[column].blocks();
    std::copy(blocks.begin(), blocks.end(), &window.blocks[column * kSpan]);
  }
  auto& mesher = mesherOfThread<Side>();
  if (mesher.mesh(window, surface_->iso_)) keep(key, mesher.content());
}

template <int Side>
void Surface<Side>::Sweep::keep(Key key, const PatchContent& content) {
  dropUntil(key);
  ++report.meshed;
  report.crossing += content.cubes.size();
  report.vertices += content.owned;
  report.triangles += content.indices.size() / 3;
  if (existing_ == surface_->patches_.end() || existing_->first != key) {
    fresh.push_back({key, Ref<SurfacePatch>(new SurfacePatch(content)), existing_});
    addTo(added, *fresh.back().patch);
    report.changed.push_back(key);
    return;
  }
  SurfacePatch& patch = *(existing_++)->second.block;
  if (patch.content().sameAs(content)) return;
  addTo(removed, patch);
  report.changed.push_back(key);
  if (patch.holders() == 1) {
    patch.assign(content);
    addTo(added, patch);
  } else {
    replaced.push_back({key, Ref<SurfacePatch>(new SurfacePatch(content)), existing_});
    addTo(added, *replaced.back().patch);
  }
}

// Patches that stand before `key` in the blocks looked at have nothing left to show.
template <int Side>
void Surface<Side>::Sweep::dropUntil(Key key) {
  for (; existing_ != surface_->patches_.end() && existing_->first < key; ++existing_) {
    addTo(removed, *existing_->second.block);
    gone.push_back(existing_->first);
    report.changed.push_back(existing_->first);
  }
}

template <int Side>
RefreshReport Surface<Side>::run(const Work& work) {
  // Look at the blocks in parallel.
  constexpr std::size_t kGrain = Side == 8 ? 12 : 64;
  std::mutex mutex;
  std::vector<Sweep> sweeps;
  parallelFor(work.runs.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    Sweep sweep(*this, work.columns, begin);
    for (std::size_t n = begin; n < end; ++n) sweep.look(work.runs[n]);
    const std::lock_guard lock(mutex);
    sweeps.push_back(std::move(sweep));
  });

  // Change the tree in order of keys.
  std::sort(sweeps.begin(), sweeps.end(),
            [](const Sweep& a, const Sweep& b) { return a.begin < b.begin; });
  RefreshReport report;
  for (Sweep& sweep : sweeps) {
    apply(sweep);
    report.examined += sweep.report.examined;
    report.meshed += sweep.report.meshed;
    report.crossing += sweep.report.crossing;
    report.vertices += sweep.report.vertices;
    report.triangles += sweep.report.triangles;
    report.changed.insert(report.changed.end(), sweep.report.changed.begin(),
                          sweep.report.changed.end());
  }
  return report;
}

template <int Side>
void Surface<Side>::apply(Sweep& sweep) {
  combine(totals_, sweep.added, 1);
  combine(totals_, sweep.removed, -1);
  for (auto& [key, patch, next] : sweep.fresh) patches_.insert(next, key, std::move(patch));
  for (auto& [key, patch, next] : sweep.replaced) patches_.put(key, std::move(patch));
  for (const Key key : sweep.gone) patches_.erase(key);
}

template <int Side>
RefreshReport Surface<Side>::rebuild(const FieldType& field) {
  std::vector<Key> old;
  for (const auto& [key, run] : patches_) old.push_back(key);
  patches_.clear();
  totals_ = {};
  iso_ = field.scale.iso;
  const Columns<Side> columns(field);
  std::vector<TouchedRun> stored;
  for (const auto& [key, run] : field.tree) {
    stored.push_back({{key, run.length}, {Reach::below, Reach::below, Reach::below}});
  }
  RefreshReport report = run({columns, dilated(joined(std::move(stored)), 1, 0)});
  std::vector<Key> changed;
  std::set_union(old.begin(), old.end(), report.changed.begin(), report.changed.end(),
                 std::back_inserter(changed));
  report.changed = std::move(changed);
  return report;
}

template <int Side>
RefreshReport Surface<Side>::refresh(const FieldType& field, std::span<const KeyRun> changed) {
  std::vector<TouchedRun> touched;
  touched.reserve(changed.size());
  for (const KeyRun& run : changed) touched.push_back({run});
  return refreshTouched(field, std::move(touched));
}

template <int Side>
RefreshReport Surface<Side>::refresh(const FieldType& field, std::span<const ChangedRun> changed) {
  std::vector<TouchedRun> touched;
  touched.reserve(changed.size());
  for (const ChangedRun& run : changed) touched.push_back({run, reachOf<Side>(run.corners)});
  return refreshTouched(field, std::move(touched));
}

template <int Side>
RefreshReport Surface<Side>::refresh(const FieldType& field, const Delta<Block>& delta) {
  return refreshTouched(field, touchedRuns<Side>(delta));
}

template <int Side>
RefreshReport Surface<Side>::refreshTouched(const FieldType& field,
                                            std::vector<TouchedRun> touched) {
  if (field.scale.iso != iso_) return rebuild(field);
  constexpr int above = BlockWindow<Side>::kAbove;
  const std::vector<KeyRun> runs = dilated(joined(std::move(touched)), above, 1);
  std::vector<TouchedRun> looked;
  looked.reserve(runs.size());
  for (const KeyRun& run : runs) looked.push_back({run});
  const std::vector<KeyRun> read = dilated(looked, 1, above);
  return run({Columns<Side>(field, read), runs});
}

template <int Side>
std::size_t Surface<Side>::bytes() const {
  std::size_t sum = patches_.nodeBytes();
  for (const auto& [key, run] : patches_) sum += run.block->bytes();
  return sum;
}

template class Surface<1>;
template class Surface<8>;

}  // namespace bozzetto
