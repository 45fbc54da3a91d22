// fieldHash: layers of equal i are hashed on their own, in parallel, then the list of layers.
#include <bit>
#include <vector>

#include "bozzetto/base/bytes.hpp"
#include "bozzetto/base/hash.hpp"
#include "bozzetto/field/field.hpp"

namespace bozzetto {
namespace {

// Gathers corners of one (i, j) row in k order into maximal runs of equal content.
class RunWriter {
 public:
  void row(std::int32_t i, std::int32_t j) {
    flush();
    i_ = i;
    j_ = j;
  }
  void add(std::int64_t k, std::int64_t length, float value, Attributes attributes) {
    if (!(value > 0)) return flush();
    const bool goesOn =
        length_ > 0 && k == k_ + length_ && value == value_ && attributes == attributes_;
    if (!goesOn) {
      flush();
      k_ = k;
      value_ = value;
      attributes_ = attributes;
    }
    length_ += length;
  }
  void flush() {
    if (length_ == 0) return;
    writer_.put(i_);
    writer_.put(j_);
    writer_.put(k_);
    writer_.put(length_);
    writer_.put(value_);
    writer_.put(attributes_);
    length_ = 0;
  }
  const Bytes& bytes() const { return writer_.bytes(); }

 private:
  ByteWriter writer_;
  std::int32_t i_ = 0, j_ = 0;
  std::int64_t k_ = 0, length_ = 0;  // a row of the whole workspace is longer than 2³¹
  float value_ = 0;
  Attributes attributes_ = 0;
};

template <int Side>
using Node = typename Field<Side>::Tree::const_iterator;

// The nodes of one (i, j) column of blocks.
template <int Side>
struct Column {
  Node<Side> begin, end;
};

template <int Side>
void addRow(RunWriter& out, const Column<Side>& column, int li, int lj) {
  for (auto node = column.begin; node != column.end; ++node) {
    const auto& [key, run] = *node;
    const int at = BlockGeometry<Side>::indexOf(li, lj, 0);
    if (run.block->interned) {
      out.add(std::int64_t{key.k} * Side, std::int64_t{run.length} * Side, run.block->value[at],
              run.block->attributes[at]);
      continue;
    }
    for (int k = 0; k < Side; ++k) {
      out.add(std::int64_t{key.k} * Side + k, 1, run.block->value[at + k],
              run.block->attributes[at + k]);
    }
  }
}

template <int Side>
std::uint64_t layerHash(const std::vector<Column<Side>>& columns, std::int32_t i) {
  RunWriter out;
  for (const Column<Side>& column : columns) {
    for (int lj = 0; lj < Side; ++lj) {
      out.row(i, column.begin->first.j * Side + lj);
      addRow<Side>(out, column, i & (Side - 1), lj);
    }
  }
  out.flush();
  return out.bytes().empty() ? 0 : hash64(out.bytes());
}

// Columns grouped into slabs of equal block index i.
template <int Side>
std::vector<std::vector<Column<Side>>> slabs(const Field<Side>& field) {
  std::vector<std::vector<Column<Side>>> result;
  for (auto node = field.tree.begin(); node != field.tree.end(); ++node) {
    const Key key = node->first;
    if (result.empty() || result.back().back().begin->first.i != key.i) result.emplace_back();
    auto& slab = result.back();
    if (slab.empty() || slab.back().begin->first.j != key.j) slab.push_back({node, node});
    slab.back().end = std::next(node);
  }
  return result;
}

}  // namespace

template <int Side>
std::uint64_t fieldHash(const Field<Side>& field) {
  const auto grouped = slabs(field);
  std::vector<std::uint64_t> hashes(grouped.size() * Side);
  parallelFor(hashes.size(), Side, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const auto& slab = grouped[n / Side];
      const std::int32_t i = slab.front().begin->first.i * Side + static_cast<int>(n % Side);
      hashes[n] = layerHash<Side>(slab, i);
    }
  });
  ByteWriter list;
  for (std::size_t n = 0; n < hashes.size(); ++n) {
    if (hashes[n] == 0) continue;
    list.put(grouped[n / Side].front().begin->first.i * Side + static_cast<int>(n % Side));
    list.put(hashes[n]);
  }
  return hash64(list.bytes());
}

template std::uint64_t fieldHash(const Field<1>&);
template std::uint64_t fieldHash(const Field<8>&);

}  // namespace bozzetto
