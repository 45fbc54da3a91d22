#include "bozzetto/solid/wrap.hpp"

#include <cmath>
#include <glm/common.hpp>

#include "bozzetto/base/error.hpp"
#include "bozzetto/base/parallel.hpp"
#include "bozzetto/solid/refine.hpp"
#include "solid/carry.hpp"
#include "solid/mass_band.hpp"

namespace bozzetto {
namespace {

constexpr std::size_t kBatch = 1024;

// Puts what was carried in the place of what was there.
void carryAll(const Carrier& carrier, const Clay& source, const std::vector<Key>& keys,
              Edit<CornerBlock<8>>& edit, Progress& progress) {
  for (std::size_t first = 0; first < keys.size(); first += kBatch) {
    progress.step("wrap", double(first) / double(keys.size()));
    const std::size_t count = std::min(kBatch, keys.size() - first);
    std::vector<Ref<CornerBlock<8>>> blocks(count);
    parallelFor(count, 4, [&](std::size_t begin, std::size_t end) {
      FieldSampler<8> sampler(source);
      for (std::size_t n = begin; n < end; ++n)
        blocks[n] = carrier.carried(keys[first + n], sampler);
    });
    for (std::size_t n = 0; n < count; ++n) {
      const bool own = blocks[n] && !blocks[n]->interned;
      const auto block = own ? edit.own(std::move(blocks[n])) : std::move(blocks[n]);
      edit.replace({keys[first + n], 1}, block);
    }
  }
}

WrapReport applyOn(Edit<CornerBlock<8>>& edit, const FieldScale& scale, const Lattice& rest,
                   std::span<const glm::dvec3> posed, const WrapOptions& options,
                   Progress& progress) {
  if (options.levels < 1 || options.levels > 4)
    throw Error("wrap: found " + std::to_string(options.levels) + " levels, expected 1 to 4");
  if (posed.size() != rest.points.size())
    throw Error("wrap: found " + std::to_string(posed.size()) + " posed points, expected " +
                std::to_string(rest.points.size()));
  const Refined refined = refine(rest, options.levels);
  const Clay source{edit.tree(), scale};
  const Carrier carrier(refined.lattice, inCells(refined.rows, rest.points, scale.spacing),
                        inCells(refined.rows, posed, scale.spacing), source);
  const std::vector<Key> keys = carrier.blocks();
  WrapReport report;
  report.massBefore = massOf(edit.tree(), keys);
  try {
    carryAll(carrier, source, keys, edit, progress);
    if (options.keepMass == KeepMass::yes) report.offset = matchMass(edit, keys, report.massBefore);
  } catch (...) {
    edit.rollback();
    throw;
  }
  report.massAfter = massOf(edit.tree(), keys);
  report.dirty = std::int64_t(keys.size()) * 512;
  return report;
}

// Blocks of side 1 go by way of side 8: corner by corner they become what those are.
void copyBack(const Clay& from, Edit<CornerBlock<1>>& edit) {
  std::vector<Key> old;
  for (const auto& [key, run] : edit.tree()) old.push_back(key);
  for (const Key key : old)
    if (from.value(key) <= 0) edit.replace({key, 1}, nullptr);
  const Field<1> corners = withSide<1>(from);
  for (const auto& [key, run] : corners.tree) {
    CornerBlock<1>& block = edit.write(key);
    block.value = run.block->value;
    block.attributes = run.block->attributes;
    block.updateRange();
  }
}

WrapReport applyOn(Edit<CornerBlock<1>>& edit, const FieldScale& scale, const Lattice& rest,
                   std::span<const glm::dvec3> posed, const WrapOptions& options,
                   Progress& progress) {
  Clay clay = withSide<8>(Field<1>{edit.tree(), scale});
  Edit<CornerBlock<8>> inner(clay.tree);
  const WrapReport report = applyOn(inner, scale, rest, posed, options, progress);
  inner.commit();
  copyBack(clay, edit);
  return report;
}

}  // namespace

NamedLattice wrapBlock(const glm::dvec3& low, const glm::dvec3& high, Key cells) {
  const glm::dvec3 size = high - low;
  for (int axis = 0; axis < 3; ++axis) {
    if (size[axis] > 0 && std::isfinite(size[axis])) continue;
    throw Error("wrap: found a box of size " + std::to_string(size[axis]) +
                ", expected a number above 0");
  }
  for (const Axis axis : kAxes) {
    if (cells[axis] >= 1 && cells[axis] <= 64) continue;
    throw Error("wrap: found " + std::to_string(cells[axis]) +
                " cells, expected 1 to 64 on each axis");
  }
  BlockOptions options;
  options.cells = cells + Key{2, 2, 2};
  options.edge = size / glm::dvec3(cells.i, cells.j, cells.k);
  options.centre = (low + high) / 2.0;
  return makeBlock(options);
}

template <int Side>
std::array<glm::dvec3, 2> clayBox(const Field<Side>& field) {
  const KeyBox box = statistics(field).bounds;
  if (box.empty()) throw Error("wrap: found no clay, expected some to wrap");
  const auto place = [&](Key key, double rim) {
    return (glm::dvec3(key.i, key.j, key.k) + rim) * field.scale.spacing;
  };
  return {place(box.low, -0.5), place(box.high, 0.5)};
}

template <int Side>
WrapReport applyWrap(Edit<CornerBlock<Side>>& edit, const FieldScale& scale, const Lattice& rest,
                     std::span<const glm::dvec3> posed, const WrapOptions& options,
                     Progress& progress) {
  return applyOn(edit, scale, rest, posed, options, progress);
}

template WrapReport applyWrap(Edit<CornerBlock<1>>&, const FieldScale&, const Lattice&,
                              std::span<const glm::dvec3>, const WrapOptions&, Progress&);
template WrapReport applyWrap(Edit<CornerBlock<8>>&, const FieldScale&, const Lattice&,
                              std::span<const glm::dvec3>, const WrapOptions&, Progress&);
template std::array<glm::dvec3, 2> clayBox(const Field<1>&);
template std::array<glm::dvec3, 2> clayBox(const Field<8>&);

}  // namespace bozzetto
