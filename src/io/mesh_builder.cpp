#include "io/mesh_builder.hpp"

#include <limits>
#include <string>

#include "bozzetto/base/error.hpp"
#include "bozzetto/mesh/check.hpp"

namespace bozzetto {

void appendFan(TriangleMesh& mesh, std::span<const std::uint32_t> polygon) {
  for (std::size_t n = 2; n < polygon.size(); ++n) {
    mesh.triangles.push_back({polygon[0], polygon[n - 1], polygon[n]});
  }
}

std::uint8_t colourByte(double unit) {
  if (!(unit > 0)) return 0;
  return unit >= 1 ? 255 : static_cast<std::uint8_t>(unit * 255 + 0.5);
}

void requireMesh(const TriangleMesh& mesh, std::string_view name) {
  constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max() / 3;
  if (mesh.triangles.empty()) {
    throw Error(std::string(name) + ": found no triangles, expected at least one");
  }
  if (mesh.triangles.size() > most || mesh.positions.size() > 3 * most) {
    throw Error(std::string(name) + ": found " + std::to_string(mesh.triangles.size()) +
                " triangles, expected at most " + std::to_string(most));
  }
  validate(mesh, name);
}

}  // namespace bozzetto
