#include "bozzetto/solid/block.hpp"

#include <cmath>
#include <map>

#include "bozzetto/base/error.hpp"

namespace bozzetto {
namespace {

constexpr std::int32_t kMostAlong = 256;
constexpr std::int64_t kMostCells = std::int64_t{1} << 18;

void requireSane(const BlockOptions& options) {
  const KeyBox cells{{0, 0, 0}, options.cells - Key{1, 1, 1}};
  for (const Axis axis : kAxes) {
    const std::int32_t count = options.cells[axis];
    if (count >= 1 && count <= kMostAlong) continue;
    throw Error("solid: found " + std::to_string(count) + " cells, expected 1 to 256 on each axis");
  }
  if (cells.count() > kMostCells)
    throw Error("solid: found " + std::to_string(cells.count()) + " cells, expected at most 2^18");
  for (int axis = 0; axis < 3; ++axis) {
    if (options.edge[axis] > 0 && std::isfinite(options.edge[axis])) continue;
    throw Error("solid: found an edge of " + std::to_string(options.edge[axis]) +
                ", expected a number above 0");
  }
  for (const Key cell : options.removed) {
    if (!cells.contains(cell))
      throw Error("solid: found removed cell " + toText(cell) + ", expected one of the block");
  }
}

// Numbers points and faces as they are first asked for.
class Builder {
 public:
  explicit Builder(const BlockOptions& options) : options_(options) {}

  void cell(Key key) {
    std::array<Id, 6> faces;
    for (const Axis axis : kAxes) {
      Key beyond = key;
      ++beyond[axis];
      faces[static_cast<std::size_t>(2 * index(axis))] = face(key, axis);
      faces[static_cast<std::size_t>(2 * index(axis) + 1)] = face(beyond, axis);
    }
    result.lattice.cells.add(faces);
  }

  NamedLattice result;

 private:
  Id point(Key key) {
    const auto [place, added] = points_.try_emplace(key, static_cast<Id>(points_.size()));
    if (added) {
      const glm::dvec3 cells(key.i, key.j, key.k);
      const glm::dvec3 size(options_.cells.i, options_.cells.j, options_.cells.k);
      result.lattice.points.push_back(options_.centre + (cells - 0.5 * size) * options_.edge);
      result.names.push_back(key);
    }
    return place->second;
  }

  Id face(Key key, Axis axis) {
    const std::size_t known = result.lattice.faces.size();
    const auto [place, added] =
        faces_[static_cast<std::size_t>(index(axis))].try_emplace(key, static_cast<Id>(known));
    if (!added) return place->second;
    const Axis u = next(axis), v = next(u);
    std::array<Key, 4> loop{key, key, key, key};
    ++loop[1][u], ++loop[2][u], ++loop[2][v], ++loop[3][v];
    result.lattice.faces.add({point(loop[0]), point(loop[1]), point(loop[2]), point(loop[3])});
    return place->second;
  }

  const BlockOptions& options_;
  std::map<Key, Id> points_;
  std::array<std::map<Key, Id>, 3> faces_;
};

}  // namespace

NamedLattice makeBlock(const BlockOptions& options) {
  requireSane(options);
  std::map<Key, bool> removed;
  for (const Key cell : options.removed) removed[cell] = true;
  Builder builder(options);
  for (std::int32_t i = 0; i < options.cells.i; ++i)
    for (std::int32_t j = 0; j < options.cells.j; ++j)
      for (std::int32_t k = 0; k < options.cells.k; ++k)
        if (!removed.contains({i, j, k})) builder.cell({i, j, k});
  if (builder.result.lattice.cells.size() == 0)
    throw Error("solid: all cells removed, expected at least one to stay");
  return std::move(builder.result);
}

}  // namespace bozzetto
