#include "tool/handle_room.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>

#include "tool/density_grid.hpp"

namespace bozzetto {
namespace {

struct Layers {
  std::array<int, 3> wide;
  std::array<std::ptrdiff_t, 3> stride;
  std::size_t along, a, b;  // axes: the one nearest to the contact direction, the others
};

Layers layersOf(const std::array<int, 3>& wide, const glm::dvec3& contact) {
  const glm::dvec3 size = glm::abs(contact);
  const std::size_t along = size.z >= std::max(size.x, size.y) ? 2 : size.y >= size.x ? 1 : 0;
  const std::ptrdiff_t j = wide[2], i = j * wide[1];
  return {wide, {i, j, 1}, along, (along + 1) % 3, (along + 2) % 3};
}

// Of the layer from `from`, between its corners; nothing beyond them.
float between(const std::vector<float>& room, const Layers& layers, std::ptrdiff_t from,
              const std::array<double, 2>& at) {
  float sum = 0;
  const int a = int(std::floor(at[0])), b = int(std::floor(at[1]));
  for (const int n : {a, a + 1})
    for (const int m : {b, b + 1}) {
      const double weight = (1 - std::abs(at[0] - n)) * (1 - std::abs(at[1] - m));
      if (!(weight > 0) || n < 0 || m < 0) continue;
      if (n >= layers.wide[layers.a] || m >= layers.wide[layers.b]) continue;
      const auto corner = from + n * layers.stride[layers.a] + m * layers.stride[layers.b];
      sum += float(weight) * room[std::size_t(corner)];
    }
  return sum;
}

}  // namespace

// Layer by layer away from the clay.
HandleRoom::HandleRoom(const Clay& clay, const KeyBox& bounds, const glm::dvec3& contact, int reach)
    : low_(bounds.low - Key{reach, reach, reach}) {
  std::size_t count = 1;
  for (const Axis axis : kAxes) {
    const auto a = static_cast<std::size_t>(index(axis));
    wide_[a] = bounds.high[axis] - bounds.low[axis] + 1 + 2 * reach;
    count *= static_cast<std::size_t>(wide_[a]);
  }
  room_.assign(count, 0);
  readDensities(clay, low_, wide_, room_);
  for (float& room : room_) room = std::min(room, 1.0f);
  const Layers layers = layersOf(wide_, contact);
  const auto on = [&](std::size_t axis) { return contact[int(axis)]; };
  const double steep = std::abs(on(layers.along));
  const double drift[2] = {on(layers.a) / steep, on(layers.b) / steep};
  const int depth = wide_[layers.along], toClay = on(layers.along) < 0 ? -1 : 1;
  for (int n = 1; n < depth; ++n) {
    const int layer = toClay < 0 ? n : depth - 1 - n;
    const std::ptrdiff_t own = layer * layers.stride[layers.along];
    const std::ptrdiff_t next = own + toClay * layers.stride[layers.along];
    for (int a = 0; a < wide_[layers.a]; ++a)
      for (int b = 0; b < wide_[layers.b]; ++b) {
        const auto at = own + a * layers.stride[layers.a] + b * layers.stride[layers.b];
        float& room = room_[std::size_t(at)];
        room = std::max(room, between(room_, layers, next, {a + drift[0], b + drift[1]}));
      }
  }
}

}  // namespace bozzetto
