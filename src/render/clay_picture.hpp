// The clay as one eye sees it, kept with its depth: copied while nothing changes, redrawn where
// patches changed, refined while all is still.
#pragma once
#include <optional>

#include "bozzetto/render/viewport.hpp"
#include "render/renderer_impl.hpp"

namespace bozzetto {

/// Boxes of clay as rectangles of the picture, near ones joined; empty when all of it is touched.
std::vector<PixelRect> touchedParts(const Frame& frame, std::span<const CellBounds> boxes);

class ClayPicture {
 public:
  explicit ClayPicture(Renderer::Impl& renderer) : renderer_(renderer) {}

  struct Request {
    Shot shot;
    Look look;
    Quality quality = Quality::light;
    bool onProcessor = false;
    double now = 0;
    bool mayRefine = false;  // nobody has done anything for a while
  };
  struct Report {
    FrameReport::Clay clay = FrameReport::Clay::kept;
    std::size_t triangles = 0;
    bool settled = false;
  };
  Report bring(const Request& request);
  /// Whether it is a picture of this view, in this size; clay may have changed since. The detail
  /// that quality chooses is no reason to draw a still view again.
  bool shows(const Request& request) const;

  const Target& picture() const { return shown_; }
  /// Another number whenever the picture is another.
  std::uint64_t version() const { return version_; }
  int slices() const { return refined_.slices; }
  /// Of the picture as it was last drawn whole, for overlays.
  const Frame& frame() const { return frame_; }

 private:
  bool wantsCoarse(const Request& request) const;
  Report draw(const Request& request, Fineness fineness);
  std::optional<Report> patch(const Request& request, std::span<const CellBounds> boxes);
  Report refine(const Request& request);
  void makeRoom(const Request& request);
  void bindForDrawing() const;
  void resolve(const PixelRect& part) const;
  void showMean();

  Renderer::Impl& renderer_;
  Target shown_;
  std::optional<Multisampled> multisampled_;
  SliceSum refined_;
  Frame frame_;

  // What `shown_` holds.
  bool valid_ = false, meanShown_ = false;
  Shot shot_;
  Look look_, drawnLook_;  // as asked for, with the detail drawn
  Fineness fineness_ = Fineness::fine;
  std::uint64_t revision_ = 0, version_ = 0;
  double lastMove_ = -1e9;
};

}  // namespace bozzetto
