#include <algorithm>

#include "bozzetto/surface/surface.hpp"
#include "surface/vertex_numbers.hpp"

namespace bozzetto {
namespace {

bool ascends(std::span<const std::uint16_t> ids) {
  return std::adjacent_find(ids.begin(), ids.end(), std::greater_equal<>()) == ids.end();
}

std::optional<std::string> faultOf(const PatchContent& content, int edgeIds) {
  if (content.cubes.empty() || content.indices.empty()) return "empty patch";
  if (content.indices.size() % 3 != 0) return "part of a triangle";
  if (!ascends(content.edges.first(content.owned))) return "owned edges out of order";
  if (!ascends(content.edges.subspan(content.owned))) return "copied edges out of order";
  for (const auto id : content.edges)
    if (id >= edgeIds) return "edge id out of range";
  for (const auto vertex : content.indices)
    if (vertex >= content.vertices.size()) return "index out of range";
  for (const CrossingCube& cube : content.cubes)
    if (cube.mask == 0 || cube.mask >= 255) return "cube that does not cross";
  return std::nullopt;
}

// Copies must be what the owner has, the block's offset aside.
template <int Side>
std::optional<std::string> seamFault(const VertexNumbers<Side>& numbers, Key key,
                                     const PatchContent& content) {
  for (std::size_t n = content.owned; n < content.vertices.size(); ++n) {
    const auto owner = numbers.ownerOf(key, content.edges[n]);
    if (owner.entry == nullptr) return "copied vertex without owner";
    PatchVertex original = owner.entry->patch->content().vertices[owner.vertex];
    const Key step = (owner.entry->key - key) * Side;
    for (const Axis axis : kAxes) original.position[index(axis)] += static_cast<float>(step[axis]);
    if (!(original == content.vertices[n])) return "copied vertex differs from its original";
  }
  return std::nullopt;
}

}  // namespace

template <int Side>
std::optional<std::string> Surface<Side>::validate() const {
  if (auto fault = patches_.validate()) return fault;
  const VertexNumbers<Side> numbers(*this);
  SurfaceTotals sum;
  for (const auto& entry : numbers.entries()) {
    const PatchContent content = entry.patch->content();
    auto fault = faultOf(content, PatchEdges<Side>::kIds);
    if (!fault) fault = seamFault<Side>(numbers, entry.key, content);
    if (fault) return *fault + " in patch " + toText(entry.key);
    sum.patches += 1;
    sum.crossingCubes += static_cast<std::int64_t>(content.cubes.size());
    sum.edges += static_cast<std::int64_t>(content.owned);
    sum.triangles += static_cast<std::int64_t>(content.indices.size() / 3);
  }
  if (!(sum == totals_)) return "totals do not add up";
  return std::nullopt;
}

template std::optional<std::string> Surface<1>::validate() const;
template std::optional<std::string> Surface<8>::validate() const;

}  // namespace bozzetto
