// Solids as bytes: what decodes must be a lattice, encode to the same bytes, and refine.
#include <cstdlib>

#include "bozzetto/base/error.hpp"
#include "bozzetto/solid/refine.hpp"
#include "bozzetto/solid/solid_codec.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace bozzetto;
  const auto bytes = std::as_bytes(std::span(data, size));
  SolidRef solid;
  try {
    solid = decodeSolid(bytes, "fuzz");
  } catch (const Error&) {
    return 0;
  }
  if (solid == nullptr) return 0;
  const Bytes again = encodeSolid(solid);
  if (again.size() != size || !(*decodeSolid(again, "again") == *solid)) std::abort();
  if (solid->control.cells.size() > 100) return 0;
  if (validate(refine(solid->control, 1).lattice)) std::abort();
  return 0;
}
