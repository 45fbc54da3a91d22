// Grey pictures as clay: a relief on the plane z = 0, bright parts high.
#pragma once
#include "bozzetto/field/field.hpp"
#include "bozzetto/io/grey_image.hpp"

namespace bozzetto {

struct ReliefOptions {
  double width = 64;   ///< of the picture, world units; its height follows
  double height = 8;   ///< of white, world units
  double spacing = 1;  ///< world units per cell
  Colour colour{};
};

/// x to the right, y up, centred; the surface is z = grey · height, without undercuts, over a flat
/// back at z = 0. Black has no clay. Values are clamp(½ − distance/2), distance along the slope.
/// Throws Error for numbers that are not above 0 and for reliefs of more than 2²⁸ cells.
Clay relief(const GreyImage& image, const ReliefOptions& options);

/// Text, drawn as distances (`drawText`), as letters with upright sides that stand on z = 0, their
/// edges rounded by a cell and a half where there is room: sharp ones would be serrated. Throws
/// Error as `relief` does.
Clay standingText(const GreyImage& outline, const ReliefOptions& options);

}  // namespace bozzetto
