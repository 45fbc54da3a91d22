// A still of clay, from nothing but the clay: what `bozzetto render` makes.
#pragma once
#include "bozzetto/base/progress.hpp"
#include "bozzetto/field/field.hpp"
#include "bozzetto/render/camera.hpp"
#include "bozzetto/render/image.hpp"
#include "bozzetto/render/look.hpp"
#include "bozzetto/surface/surface.hpp"

namespace bozzetto {

struct PictureOptions {
  int width = 1280, height = 960;  ///< pixels, 16…8192
  Viewpoint viewpoint = Viewpoint::hero;
  Projection projection = Projection::perspective;
  Look look;
  int slices = 12;  ///< 1…64: edges, shadows and grain get smoother, time grows in proportion
};

/// The surface of `clay` in the studio, framed; an empty stage when there is none. Makes its own
/// off-screen context. The same input gives the same pixels on the same driver. Throws Error for a
/// size out of range or where OpenGL cannot be had, Cancelled through `progress`.
/// 400,000 triangles at 1280 × 960: 2–3 s on two cores without a graphics card.
Image renderPicture(const Surface<8>& surface, const Clay& clay, const PictureOptions& options,
                    Progress& progress = Progress::none());

}  // namespace bozzetto
