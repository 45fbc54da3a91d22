// Patches of a surface as the renderer takes them.
#pragma once
#include <glm/vec3.hpp>
#include <vector>

#include "bozzetto/render/camera.hpp"
#include "bozzetto/render/patch.hpp"
#include "bozzetto/surface/patch.hpp"

namespace bozzetto {

/// A surface patch in arrays of its own. `light` starts empty.
struct UnpackedPatch {
  Key origin;
  std::vector<glm::vec3> positions, normals;
  std::vector<Colour> colours;
  std::vector<std::uint16_t> indices;
  std::vector<VertexLight> light;
  std::vector<std::uint8_t> hold;        ///< empty where nothing is held
  std::vector<std::int8_t> stiffness{};  ///< −127 … 127; starts empty: nothing is painted
  Fineness fineness = Fineness::fine;

  /// A patch that is gone.
  explicit UnpackedPatch(Key firstCorner) : origin(firstCorner) {}
  /// `firstCorner` is the block's first corner, in cells.
  UnpackedPatch(Key firstCorner, const SurfacePatch& patch);
  UnpackedPatch(Key firstCorner, std::span<const PatchVertex> vertices,
                std::span<const std::uint16_t> triangles);

  PatchVertices view() const {
    return {origin, positions, normals, colours, indices, light, hold, stiffness, fineness};
  }
  /// Of the vertices, in cells.
  CellBounds bounds() const;
};

}  // namespace bozzetto
