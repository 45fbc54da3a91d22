// What every mesh reader promises for any bytes: a valid mesh or an Error, in little memory.
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "bozzetto/base/error.hpp"
#include "bozzetto/mesh/check.hpp"

namespace bozzetto {

template <class Reader>
int fuzzMeshReader(Reader reader, const std::uint8_t* data, std::size_t size) {
  TriangleMesh mesh;
  try {
    mesh = reader(std::as_bytes(std::span(data, size)), "fuzz");
  } catch (const Error&) {
    return 0;
  }
  // Outside the try: an invalid mesh, or a check that throws, is our bug.
  validate(mesh);
  if (mesh.triangles.empty()) std::abort();
  if (size < 1 << 16) checkMesh(mesh);
  return 0;
}

}  // namespace bozzetto
