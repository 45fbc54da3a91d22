#include "bozzetto/io/stl.hpp"
#include "fuzz_mesh.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return bozzetto::fuzzMeshReader(
      [](auto bytes, auto name) { return bozzetto::readStl(bytes, name); }, data, size);
}
