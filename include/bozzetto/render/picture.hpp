// A still of clay, from nothing but the clay: what `bozzetto render` makes.
#pragma once
#include "bozzetto/base/function_ref.hpp"
#include "bozzetto/base/progress.hpp"
#include "bozzetto/field/field.hpp"
#include "bozzetto/render/camera.hpp"
#include "bozzetto/render/image.hpp"
#include "bozzetto/render/look.hpp"
#include "bozzetto/render/renderer.hpp"
#include "bozzetto/render/structure.hpp"
#include "bozzetto/surface/surface.hpp"

namespace bozzetto {

struct PictureOptions {
  int width = 1280, height = 960;  ///< pixels, 16…32768
  Viewpoint viewpoint = Viewpoint::hero;
  std::optional<double> yaw, pitch;  ///< instead of the viewpoint's, radians
  std::optional<Camera> camera;      ///< instead of all these; the picture's own height counts
  double zoom = 1;                   ///< 1 shows all clay; 2 its middle twice as large; .05…50
  Projection projection = Projection::perspective;
  Look look;
  Structure structure = Structure::surface;
  Stereo stereo;
  int slices = 12;  ///< 1…64: edges, shadows and grain get smoother, time grows in proportion
  int frames = 1;   ///< of one turn about the vertical, 1…3600
};

/// The surface of `clay` in the studio, framed; an empty stage when there is none. Makes its own
/// off-screen context. The same input gives the same pixels on the same driver. Throws Error for a
/// size out of range or where OpenGL cannot be had, Cancelled through `progress`.
/// 400,000 triangles at 1280 × 960: 2–3 s on two cores without a graphics card.
Image renderPicture(const Surface<8>& surface, const Clay& clay, const PictureOptions& options,
                    Progress& progress = Progress::none());

/// A turntable: `frames` pictures around the clay, each handed over as it is done.
void renderTurn(const Surface<8>& surface, const Clay& clay, const PictureOptions& options,
                FunctionRef<void(int frame, const Image&)> take,
                Progress& progress = Progress::none());

/// A still of any size from a renderer that has its clay: in parts where the picture is larger than
/// what is drawn at once. Restarts the renderer's slices.
Image still(Renderer& renderer, const Shot& shot, const Look& look, int slices,
            Progress& progress = Progress::none());

/// What both eyes see in one picture, as `stereo` says; for quad-buffer side by side.
Image stereoStill(Renderer& renderer, const Shot& shot, const Look& look, const Stereo& stereo,
                  int slices, Progress& progress = Progress::none());

}  // namespace bozzetto
