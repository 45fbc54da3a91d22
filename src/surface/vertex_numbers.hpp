// One number for each vertex of a surface: patches in key order, owned vertices in patch order.
// A copy on a + face has the number of the vertex it copies.
#pragma once
#include <cstdint>
#include <vector>

#include "bozzetto/surface/surface.hpp"

namespace bozzetto {

template <int Side>
class VertexNumbers {
 public:
  struct Entry {
    Key key;
    const SurfacePatch* patch;
    std::size_t firstVertex, firstTriangle;
  };
  static constexpr std::size_t kNone = ~std::size_t{0};

  explicit VertexNumbers(const Surface<Side>& surface);

  const std::vector<Entry>& entries() const { return entries_; }
  std::size_t vertexCount() const { return vertices_; }
  std::size_t triangleCount() const { return triangles_; }

  /// Numbers of all vertices of a patch; kNone where the owner does not have the edge.
  void numbersOf(const Entry& entry, std::vector<std::size_t>& numbers) const;

  /// The owner of the edge `id` seen from the block at `key`, and its place there.
  struct Owner {
    const Entry* entry = nullptr;
    std::size_t vertex = kNone;
  };
  Owner ownerOf(Key key, int id) const;

 private:
  const Entry* find(Key key) const;

  std::vector<Entry> entries_;
  std::size_t vertices_ = 0, triangles_ = 0;
};

extern template class VertexNumbers<1>;
extern template class VertexNumbers<8>;

}  // namespace bozzetto
