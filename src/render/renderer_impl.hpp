// The renderer's inside: programs, patches, textures, and the passes of a frame.
#pragma once
#include <array>
#include <optional>

#include "bozzetto/render/renderer.hpp"
#include "render/change_log.hpp"
#include "render/frame.hpp"
#include "render/patch_store.hpp"
#include "render/stage_textures.hpp"
#include "render/studio_cache.hpp"

namespace bozzetto {

struct Programs {
  gl::Program clay, baked, metal, glass, matcap, wire;
  gl::Program depth, background, floor, floorWithoutShadow, bake, copy;
  Programs();
};

/// A slice in progress: what is left to draw of it.
struct SliceProgress {
  Frame frame;
  std::vector<PatchStore::Seen> shadow, clay;
  std::size_t shadowDone = 0, clayDone = 0;
  bool backgroundDone = false;
  std::uint64_t shadowTicket = 0;
};

/// A picture that grows better slice by slice: one slice, and the sum of slices / kScale.
struct SliceSum {
  static constexpr float kScale = 16;
  std::optional<Target> slice, sum;
  int slices = 0;

  std::optional<SliceProgress> progress;

  void restart() {
    slices = 0;
    progress.reset();
  }
};

struct Renderer::Impl {
  Programs programs;
  std::array<PatchStore, 3> stores;  // by fineness
  UploadCounters uploads;
  ChangeLog changes;
  gl::VertexArray nothing = gl::newVertexArray();  // for triangles made in the vertex shader
  gl::Buffer frameBuffer = gl::newBuffer(), studioBuffer = gl::newBuffer();
  gl::Texture floorMap;
  ShadowMap shadow;
  std::uint64_t shadowTicket = 0;  // grows whenever the shadow map is begun anew
  StudioCache studios;
  SliceSum still;

  Impl();
  PatchStore& store(Fineness fineness) { return stores[std::size_t(fineness)]; }
  const PatchStore& store(Fineness fineness) const { return stores[std::size_t(fineness)]; }
  /// What is drawn where nothing else is asked for.
  Fineness finest() const {
    return store(Fineness::heights).triangleCount() > 0 ? Fineness::heights : Fineness::fine;
  }

  /// A frame into the bound framebuffer's lower left corner; returns the triangles drawn.
  std::size_t drawFrame(const Shot& shot, const Look& look, Fineness fineness, int taps = 16);
  /// The same where clip space shows `part` pixels of it: only there.
  std::size_t redrawPart(const Shot& shot, const Look& look, const PixelRect& part);

  /// Draws about `triangles` of the next slice, all of it for 0. True when a slice is complete.
  bool advance(SliceSum& sum, const Shot& shot, const Look& look, std::size_t triangles = 0);
  void show(const SliceSum& sum);
  void drawTriangle(const gl::Program& program);

 private:
  void setUp(const Frame& frame, const Look& look);
  void bindStudio(const Frame& frame, const Look& look);
  void bindBall(const StudioBlock& block, const StudioCache::Map& map);
  void beginShadowMap();
  void drawShadows(const Frame& frame, std::span<const PatchStore::Seen> chunks);
  void drawBackdrop(const Frame& frame);
  void drawClay(const Frame& frame, const Look& look, std::span<const PatchStore::Seen> chunks);
  void drawGlass(std::span<const PatchStore::Seen> chunks);
  void drawEdges(std::span<const PatchStore::Seen> chunks);
  const gl::Program& programFor(const Look& look) const;
  void begin(SliceSum& sum, const Shot& shot, const Look& look);
  bool drawSome(SliceSum& sum, const Look& look, std::size_t triangles);
  void addTo(SliceSum& sum);
};

}  // namespace bozzetto
