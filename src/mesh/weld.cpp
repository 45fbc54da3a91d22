#include "bozzetto/mesh/weld.hpp"

#include <bit>
#include <limits>

namespace bozzetto {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

std::uint64_t mix(std::uint64_t h) {
  h = (h ^ (h >> 32)) * 0xd6e8feb86659fd93u;
  h = (h ^ (h >> 32)) * 0xd6e8feb86659fd93u;
  return h ^ (h >> 32);
}

std::uint64_t hashOf(const glm::dvec3& p) {
  std::uint64_t h = 0x9e3779b97f4a7c15u;
  // Adding zero makes -0 and 0 the same bits.
  for (int axis = 0; axis < 3; ++axis) h = mix(h ^ std::bit_cast<std::uint64_t>(p[axis] + 0.0));
  return h;
}

// Open addressing over vertex indices; at most half full.
class PositionTable {
 public:
  explicit PositionTable(const std::vector<glm::dvec3>& positions)
      : positions_(positions), slots_(std::bit_ceil(2 * positions.size() + 1), kNone) {}

  // The first vertex given with the position of `vertex`, perhaps itself.
  std::uint32_t firstAt(std::uint32_t vertex) {
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t slot = hashOf(positions_[vertex]) & mask;; slot = (slot + 1) & mask) {
      if (slots_[slot] == kNone) return slots_[slot] = vertex;
      if (positions_[slots_[slot]] == positions_[vertex]) return slots_[slot];
    }
  }

 private:
  const std::vector<glm::dvec3>& positions_;
  std::vector<std::uint32_t> slots_;
};

}  // namespace

void weldVertices(TriangleMesh& mesh) {
  // Number the distinct positions in order.
  std::vector<std::uint32_t> renumbered(mesh.positions.size());
  std::vector<std::uint32_t> kept;
  {
    PositionTable table(mesh.positions);
    for (std::uint32_t v = 0; v < renumbered.size(); ++v) {
      const auto first = table.firstAt(v);
      renumbered[v] = first == v ? static_cast<std::uint32_t>(kept.size()) : renumbered[first];
      if (first == v) kept.push_back(v);
    }
  }

  // Close the gaps.
  for (std::size_t n = 0; n < kept.size(); ++n) {
    mesh.positions[n] = mesh.positions[kept[n]];
    if (!mesh.colours.empty()) mesh.colours[n] = mesh.colours[kept[n]];
  }
  mesh.positions.resize(kept.size());
  if (!mesh.colours.empty()) mesh.colours.resize(kept.size());
  mesh.normals.clear();

  // Point the triangles at what is left.
  for (auto& triangle : mesh.triangles) {
    for (auto& vertex : triangle) vertex = renumbered[vertex];
  }
  std::erase_if(mesh.triangles, [](const TriangleMesh::Triangle& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
  });
}

}  // namespace bozzetto
