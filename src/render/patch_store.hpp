// Patches on the GPU, gathered in chunks of 64³ cells so that a frame takes few draw calls.
#pragma once
#include <map>
#include <memory>

#include "bozzetto/render/camera.hpp"
#include "bozzetto/render/patch.hpp"
#include "render/gl.hpp"
#include "render/range_allocator.hpp"

namespace bozzetto {

class PatchStore {
 private:
  struct Chunk;

 public:
  /// A chunk in sight. Good until a patch comes or goes.
  struct Seen {
    glm::vec3 origin{0};  // cells from the anchor
    const Chunk* chunk = nullptr;
    float distance = 0;

    std::size_t triangles() const { return chunk->triangles; }
  };

  PatchStore() = default;
  PatchStore(const PatchStore&) = delete;
  PatchStore& operator=(const PatchStore&) = delete;

  /// Both return where the picture changes; `bytes` counts what went to the graphics card.
  CellBounds upload(const PatchVertices& patch, std::int64_t& bytes);
  CellBounds remove(Key origin, std::int64_t& bytes);
  void clear() { chunks_.clear(); }
  std::size_t triangleCount() const;

  /// The chunks that `clipFromCells` (cells from `anchor`) can see, nearest to the anchor first.
  std::vector<Seen> seen(Key anchor, const glm::mat4& clipFromCells) const;

  /// Draws with the program in use, whose uniform `chunkOrigin` gets each chunk's place.
  static void draw(const gl::Program& program, std::span<const Seen> chunks);
  void draw(const gl::Program& program, Key anchor, const glm::mat4& clipFromCells) const {
    draw(program, seen(anchor, clipFromCells));
  }

 private:
  // 28 bytes a vertex, as the shaders read it.
  struct Vertex {
    glm::vec3 position;
    std::int16_t normalCavity[4];
    std::uint8_t colour[4];
    std::uint8_t bentOpen[4];
    std::int8_t stiffness[4];  // the first counts
  };
  struct Slot {
    std::size_t vertex, vertexCount, index, indexCount;
    CellBounds bounds;
  };
  // One buffer that grows by copying itself on the GPU.
  struct GrowingBuffer {
    gl::Buffer buffer;
    std::size_t capacity = 0;  // bytes

    bool reserve(std::size_t bytes);
    void write(std::size_t at, const void* data, std::size_t bytes);
  };
  struct Chunk {
    gl::VertexArray array;
    GrowingBuffer vertices, indices;
    RangeAllocator vertexRanges, indexRanges;
    std::map<Key, Slot> slots;
    std::size_t triangles = 0;
    CellBounds bounds;  // of all it ever had: pieces of cloths hang out of it

    Slot& put(Key origin, const std::vector<Vertex>& vertex, std::vector<std::uint32_t> index);
    CellBounds remove(Key origin, std::int64_t& bytes);
    void describeVertices();
  };

  static Key chunkOf(Key origin);
  static std::vector<Vertex> packed(const PatchVertices& patch, glm::vec3 shift);

  std::map<Key, Chunk> chunks_;
};

}  // namespace bozzetto
