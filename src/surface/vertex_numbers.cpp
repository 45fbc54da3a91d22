#include "surface/vertex_numbers.hpp"

#include <algorithm>

namespace bozzetto {

template <int Side>
VertexNumbers<Side>::VertexNumbers(const Surface<Side>& surface) {
  entries_.reserve(surface.patches().nodeCount());
  for (const auto& [key, run] : surface.patches()) {
    entries_.push_back({key, run.block.get(), vertices_, triangles_});
    vertices_ += run.block->ownedCount();
    triangles_ += run.block->triangleCount();
  }
}

template <int Side>
const typename VertexNumbers<Side>::Entry* VertexNumbers<Side>::find(Key key) const {
  const auto entry = std::partition_point(entries_.begin(), entries_.end(),
                                          [key](const Entry& e) { return e.key < key; });
  return entry != entries_.end() && entry->key == key ? &*entry : nullptr;
}

template <int Side>
typename VertexNumbers<Side>::Owner VertexNumbers<Side>::ownerOf(Key key, int id) const {
  using Edges = PatchEdges<Side>;
  const Key corner = Edges::cornerOf(id);
  const Key step{corner.i / Side, corner.j / Side, corner.k / Side};
  const Entry* const owner = find(key + step);
  if (owner == nullptr) return {};
  const PatchContent content = owner->patch->content();
  const auto owned = content.edges.first(content.owned);
  const int wanted = Edges::idOf(corner - step * Side, Edges::axisOf(id));
  const auto found = std::lower_bound(owned.begin(), owned.end(), wanted);
  if (found == owned.end() || *found != wanted) return {};
  return {owner, static_cast<std::size_t>(found - owned.begin())};
}

template <int Side>
void VertexNumbers<Side>::numbersOf(const Entry& entry, std::vector<std::size_t>& numbers) const {
  const PatchContent content = entry.patch->content();
  numbers.resize(content.vertices.size());
  for (std::size_t n = 0; n < content.owned; ++n) numbers[n] = entry.firstVertex + n;
  for (std::size_t n = content.owned; n < numbers.size(); ++n) {
    const Owner owner = ownerOf(entry.key, content.edges[n]);
    numbers[n] = owner.entry == nullptr ? kNone : owner.entry->firstVertex + owner.vertex;
  }
}

template class VertexNumbers<1>;
template class VertexNumbers<8>;

}  // namespace bozzetto
