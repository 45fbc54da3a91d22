#include "io/sniff.hpp"

#include <algorithm>
#include <string_view>

#include "bozzetto/base/bytes.hpp"
#include "io/text_reader.hpp"

namespace bozzetto {
namespace {

std::string_view firstBytes(std::span<const std::byte> bytes, std::size_t count) {
  return {reinterpret_cast<const char*>(bytes.data()), std::min(bytes.size(), count)};
}

std::string_view firstWord(std::span<const std::byte> bytes) {
  return TextReader(bytes.first(std::min<std::size_t>(bytes.size(), 256)), "", '#').word();
}

bool hasBinaryStlLength(std::span<const std::byte> bytes) {
  if (bytes.size() < 84) return false;
  const std::size_t count = ByteReader(bytes.subspan(80)).get<std::uint32_t>();
  return bytes.size() == 84 + 50 * count;
}

// "OFF" after any of the prefixes ST, C, N, 4, n.
bool isOffKeyword(std::string_view word) {
  if (word.size() < 3 || word.substr(word.size() - 3) != "OFF") return false;
  return word.substr(0, word.size() - 3).find_first_not_of("STCN4n") == std::string_view::npos;
}

}  // namespace

bool isBinaryStl(std::span<const std::byte> bytes) {
  if (hasBinaryStlLength(bytes)) return true;
  return !equalsIgnoringCase(firstWord(bytes).substr(0, 5), "solid");
}

std::optional<MeshFormat> sniffMeshFormat(std::span<const std::byte> bytes) {
  if (firstBytes(bytes, 4) == "glTF") return MeshFormat::glb;
  if (firstWord(bytes) == "ply") return MeshFormat::ply;
  if (isOffKeyword(firstWord(bytes))) return MeshFormat::off;
  if (firstBytes(bytes, 5) == "solid" || hasBinaryStlLength(bytes)) return MeshFormat::stl;
  return std::nullopt;
}

}  // namespace bozzetto
