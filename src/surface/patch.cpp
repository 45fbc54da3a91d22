#include "bozzetto/surface/patch.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "bozzetto/grid/block_pool.hpp"

namespace bozzetto {
namespace {

// Sizes in quarters of a power of two: few pools, little waste.
std::size_t roundedUp(std::size_t bytes) {
  bytes = std::max<std::size_t>(bytes, 512);
  const std::size_t step = std::bit_floor(bytes - 1) / 4;
  return (bytes + step - 1) / step * step;
}

std::size_t bytesFor(const PatchContent& c) {
  return c.vertices.size_bytes() + c.cubes.size_bytes() + c.edges.size_bytes() +
         c.indices.size_bytes();
}

template <class T>
std::byte* store(std::byte* to, std::span<const T> from) {
  std::memcpy(to, from.data(), from.size_bytes());
  return to + from.size_bytes();
}

template <class T>
std::span<const T> view(const std::byte*& from, std::size_t count) {
  const std::span<const T> result(reinterpret_cast<const T*>(from), count);
  from += result.size_bytes();
  return result;
}

template <class T>
bool equalBytes(std::span<const T> a, std::span<const T> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

}  // namespace

std::array<float, 3> octahedralNormal(std::array<std::int16_t, 2> packed) {
  float x = static_cast<float>(packed[0]) / 32767, y = static_cast<float>(packed[1]) / 32767;
  const float z = 1 - std::abs(x) - std::abs(y);
  if (z < 0) {
    const float folded = (1 - std::abs(y)) * (x < 0 ? -1.0f : 1.0f);
    y = (1 - std::abs(x)) * (y < 0 ? -1.0f : 1.0f);
    x = folded;
  }
  const float length = std::sqrt(x * x + y * y + z * z);
  return {x / length, y / length, z / length};
}

bool PatchContent::sameAs(const PatchContent& other) const {
  return owned == other.owned && equalBytes(vertices, other.vertices) &&
         equalBytes(edges, other.edges) && equalBytes(cubes, other.cubes) &&
         equalBytes(indices, other.indices);
}

SurfacePatch::~SurfacePatch() {
  if (memory_ != nullptr) releaseBlock(memory_, capacity_);
}

void SurfacePatch::assign(const PatchContent& content) {
  const std::size_t needed = bytesFor(content);
  if (needed > capacity_ || needed < capacity_ / 4) {
    if (memory_ != nullptr) releaseBlock(memory_, capacity_);
    memory_ = nullptr;
    capacity_ = static_cast<std::uint32_t>(roundedUp(needed));
    memory_ = static_cast<std::byte*>(allocateBlock(capacity_));
  }
  store(store(store(store(memory_, content.vertices), content.cubes), content.edges),
        content.indices);
  owned_ = static_cast<std::uint16_t>(content.owned);
  vertices_ = static_cast<std::uint16_t>(content.vertices.size());
  cubes_ = static_cast<std::uint16_t>(content.cubes.size());
  indices_ = static_cast<std::uint16_t>(content.indices.size());
}

PatchContent SurfacePatch::content() const {
  const std::byte* at = memory_;
  PatchContent result;
  result.owned = owned_;
  result.vertices = view<PatchVertex>(at, vertices_);
  result.cubes = view<CrossingCube>(at, cubes_);
  result.edges = view<std::uint16_t>(at, vertices_);
  result.indices = view<std::uint16_t>(at, indices_);
  return result;
}

}  // namespace bozzetto
