// Draws patches of clay in the studio. Needs a current OpenGL 3.3 core context for its whole life
// and knows nothing of where it came from: off-screen and window use the same object.
#pragma once
#include <memory>
#include <string>

#include "bozzetto/render/image.hpp"
#include "bozzetto/render/look.hpp"
#include "bozzetto/render/occlusion.hpp"
#include "bozzetto/render/patch.hpp"
#include "bozzetto/render/shot.hpp"

namespace bozzetto {

/// Since the renderer was made.
struct UploadCounters {
  std::int64_t patches = 0, bytes = 0;  ///< sent to the graphics card
};

class Renderer {
 public:
  Renderer();
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Takes a patch, replacing the one of the same origin and fineness; an empty patch removes it.
  /// Copies.
  void uploadPatch(const PatchVertices& patch);
  void removePatch(Key origin, Fineness fineness = Fineness::fine);
  void clear();
  void clear(Fineness fineness);
  std::size_t triangleCount(Fineness fineness = Fineness::fine) const;
  const UploadCounters& uploads() const;

  void setFloorOcclusion(const FloorOcclusion& floor);

  /// One frame, as it moves, into the framebuffer bound for drawing, which has a depth buffer: into
  /// its lower left corner.
  void draw(const Shot& shot, const Look& look);

  /// Still pictures are the mean of slices: shots from within the pixel, lit from within the soft
  /// box. addSlice draws one more, showSlices copies the mean to the framebuffer bound for drawing;
  /// whatever changes the picture calls restart first.
  void restart();
  void addSlice(const Shot& shot, const Look& look);
  void showSlices(const Shot& shot);
  int sliceCount() const;

  /// The mean of the slices, read back. Needs one slice at least.
  Image mean(const Shot& shot);

  /// What draws, as the driver calls itself.
  std::string driverName() const;

 private:
  friend class Viewport;
  friend class ClayPicture;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace bozzetto
