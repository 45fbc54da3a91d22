// One view of a window: keeps the clay's picture and depth between frames, so that a frame in which
// only overlays move copies it, a dab redraws its surroundings only, and a still view refines.
#pragma once
#include <memory>
#include <optional>

#include "bozzetto/render/ladder.hpp"
#include "bozzetto/render/overlays.hpp"
#include "bozzetto/render/renderer.hpp"

namespace bozzetto {

struct ViewFrame {
  Camera camera;
  Stage stage;
  Look look;  ///< `detail` is chosen by quality
  Stereo stereo;
  PixelRect place;       ///< of the framebuffer bound for drawing, pixels from its lower left
  double now = 0;        ///< seconds, any origin
  double lastInput = 0;  ///< when the person last did something; refinement waits
  bool stroke = false;   ///< quality stays as it is
};

struct FrameReport {
  enum class Clay {
    kept,     ///< the last picture copied
    patched,  ///< drawn anew where patches changed
    drawn,    ///< drawn anew
    refined,  ///< a part of a slice more
  };
  Clay clay = Clay::kept;
  Quality quality = Quality::light;
  std::size_t triangles = 0;       ///< drawn for this frame
  std::int64_t uploadedBytes = 0;  ///< since the last frame
  double milliseconds = 0;         ///< the whole call, waiting for the driver included if it drew
  int slices = 0;                  ///< complete ones in the picture shown
  bool settled = false;            ///< nothing would change without new input: sleep
};

class Viewport {
 public:
  /// The renderer outlives it; contexts as for it.
  explicit Viewport(Renderer& renderer);
  ~Viewport();
  Viewport(const Viewport&) = delete;
  Viewport& operator=(const Viewport&) = delete;

  /// Draws clay and overlays into the framebuffer bound for drawing, which has a depth buffer; the
  /// rest of it stays but for depth. Leaves blending, depth test and scissor off. A place smaller
  /// than 16 pixels a side is left alone.
  FrameReport draw(const ViewFrame& frame, const Overlays& overlays);

  /// A quality for good, or nothing: chosen by the ladder.
  void fixQuality(std::optional<Quality> quality);
  const QualityLadder& ladder() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The shot that a frame shows, for rays and handles.
Shot shotOf(const ViewFrame& frame);

}  // namespace bozzetto
