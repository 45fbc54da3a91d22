// The surface as the window's thread has it: finished patches from the worker, shared and
// unchanging. Rays find what is under the pointer here, without the graphics card.
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <unordered_map>

#include "bozzetto/render/unpack.hpp"
#include "ui/view_state.hpp"

namespace bozzetto::ui {

/// Patches lie in the block they are named after, but for those of clay that is shown posed.
enum class Lies { inItsBlock, anywhere };

/// A patch ready to be drawn and picked.
struct ShownPatch {
  UnpackedPatch data;
  CellBounds bounds;
  Lies lies;

  explicit ShownPatch(UnpackedPatch patch, Lies where = Lies::inItsBlock)
      : data(std::move(patch)), bounds(data.bounds()), lies(where) {}
  std::size_t uploadBytes() const { return data.positions.size() * 32 + data.indices.size() * 4; }
};
using PatchRef = std::shared_ptr<const ShownPatch>;

struct SurfaceHit {
  glm::dvec3 position{0};  ///< cells
  glm::dvec3 normal{0};    ///< length 1
  double distance = 0;     ///< along the ray, cells
  Colour colour;
};

class PatchSet {
 public:
  /// By the patch's first corner; null removes.
  void put(Key origin, PatchRef patch);
  void clear();

  /// The first triangle that the ray (cells) meets from outside. O(blocks along the ray).
  std::optional<SurfaceHit> pick(const Ray& ray) const;

  const CellBounds& bounds() const;
  std::size_t triangles() const { return triangles_; }
  bool empty() const { return triangles_ == 0; }
  /// The boxes of 64³ cells that hold surface.
  std::vector<CellBounds> boxes() const;

  template <class Visit>
  void forEach(const Visit& visit) const {
    for (const auto& [key, patch] : loose_) visit(*patch);
    for (const auto& [key, chunk] : chunks_)
      for (const PatchRef& patch : chunk->patches)
        if (patch) visit(*patch);
  }

 private:
  static constexpr int kSide = 8;  // patches along a chunk's side
  struct Chunk {
    std::array<PatchRef, kSide * kSide * kSide> patches;
    int count = 0;
    CellBounds bounds;
    void measure();
  };
  struct Hash {
    std::size_t operator()(Key key) const;
  };

  void putInChunk(Key origin, PatchRef patch);
  std::optional<SurfaceHit> pickIn(const Chunk& chunk, Key first, const Ray& ray) const;

  // Copying a set (to freeze what a stroke lies on) copies one pointer per chunk.
  std::unordered_map<Key, std::shared_ptr<Chunk>, Hash> chunks_;
  std::unordered_map<Key, PatchRef, Hash> loose_;  // that lie anywhere
  std::size_t triangles_ = 0;
  mutable std::optional<CellBounds> bounds_;  // of all, when asked for
};

}  // namespace bozzetto::ui
