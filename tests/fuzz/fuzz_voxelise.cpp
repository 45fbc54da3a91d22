// Any triangles at all become valid clay or an Error.
#include <array>
#include <cstdlib>
#include <span>

#include "bozzetto/base/error.hpp"
#include "bozzetto/io/voxelise.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace bozzetto;
  // Each 9 bytes are a triangle with coordinates of -8…8 cells in sixteenths.
  if (size > 9 * 64) return 0;
  TriangleMesh mesh;
  for (std::size_t n = 0; n + 9 <= size; n += 9) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::size_t corner = n; corner < n + 9; corner += 3) {
      glm::dvec3 p;
      for (int axis = 0; axis < 3; ++axis) p[axis] = static_cast<std::int8_t>(data[corner + axis]);
      mesh.positions.push_back(p / 16.0);
      mesh.colours.push_back({data[corner], data[corner + 1], data[corner + 2]});
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  Clay clay;
  try {
    Edit<CornerBlock<8>> edit(clay.tree);
    ImportOptions options;
    options.spacing = 1;
    const auto report = voxelise(mesh, options, edit);
    if (!(report.fitMax <= 1)) std::abort();
    edit.commit();
  } catch (const Error&) {
    if (!clay.tree.empty()) std::abort();
    return 0;
  }
  if (validate(clay)) std::abort();
  return 0;
}
