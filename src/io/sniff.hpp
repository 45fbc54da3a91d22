// What the first bytes of a file say about its format.
#pragma once
#include <cstddef>
#include <optional>
#include <span>

#include "bozzetto/io/mesh_file.hpp"

namespace bozzetto {

/// The format that the content proves, if any: OBJ proves nothing.
std::optional<MeshFormat> sniffMeshFormat(std::span<const std::byte> bytes);

/// Binary unless it opens with "solid" and has no exact binary length: binary headers may well
/// say "solid" too.
bool isBinaryStl(std::span<const std::byte> bytes);

}  // namespace bozzetto
