#include "bozzetto/io/relief.hpp"

#include <algorithm>
#include <cmath>

#include "bozzetto/base/error.hpp"
#include "bozzetto/base/text.hpp"

namespace bozzetto {
namespace {

// Black lies so many cells under the plane, so that edges are as steep as others.
constexpr double kBlack = 2;

// A picture on the cells of the plane.
class Greys {
 public:
  Greys(const GreyImage& image, double pixelsPerCell) : image_(&image), pixels_(pixelsPerCell) {}

  // Mean of the pixels of a cell, bilinear where cells are smaller; less at the picture's border,
  // beyond which all is black.
  double at(double x, double y) const {
    const double part = covered(x, image_->width) * covered(y, image_->height);
    if (!(part > 0)) return 0;
    const int samples = std::max(1, static_cast<int>(std::ceil(pixels_)));
    double sum = 0;
    for (int i = 0; i < samples; ++i)
      for (int j = 0; j < samples; ++j) {
        const double u = x + ((i + 0.5) / samples - 0.5), v = y + ((j + 0.5) / samples - 0.5);
        sum += grey(0.5 * image_->width + u * pixels_, 0.5 * image_->height - v * pixels_);
      }
    return part * sum / (samples * samples);
  }

 private:
  double pixel(int x, int y) const {
    x = std::clamp(x, 0, image_->width - 1);
    y = std::clamp(y, 0, image_->height - 1);
    return static_cast<double>(image_->at(x, y));
  }
  // How much of a cell lies in the picture, along one axis.
  double covered(double at, int pixels) const {
    const double half = 0.5 * pixels / pixels_;
    return std::clamp(std::min(at + 0.5, half) - std::max(at - 0.5, -half), 0.0, 1.0);
  }
  double grey(double x, double y) const {
    x -= 0.5;
    y -= 0.5;
    const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
    const double s = x - i, t = y - j;
    return (1 - t) * ((1 - s) * pixel(i, j) + s * pixel(i + 1, j)) +
           t * ((1 - s) * pixel(i, j + 1) + s * pixel(i + 1, j + 1));
  }

  const GreyImage* image_;
  double pixels_;
};

// The surface over the plane, in cells.
struct Heights {
  Greys greys;
  double white;
  double at(double x, double y) const { return greys.at(x, y) * (white + kBlack) - kBlack; }
};

// Distance to the outline of letters, in cells.
struct Outline {
  Greys greys;
  double pixels;  // a cell
  double at(double x, double y) const { return (0.5 - greys.at(x, y)) * 2 * kTextReach / pixels; }
};

void requireValid(const GreyImage& image, const ReliefOptions& o) {
  const bool sound = o.width > 0 && o.height > 0 && o.spacing > 0 && std::isfinite(o.width) &&
                     std::isfinite(o.height) && std::isfinite(o.spacing);
  if (!sound || image.width < 1 || image.height < 1) {
    throw Error("relief: width " + numberText(o.width) + ", height " + numberText(o.height) +
                " and spacing " + numberText(o.spacing) + " found, numbers above 0 expected");
  }
  const double across = o.width / o.spacing;
  const double cells = across * (across * image.height / image.width) * (o.height / o.spacing + 3);
  if (!(cells <= 1 << 28))
    throw Error("relief: " + numberText(cells) +
                " cells found, at most 2^28 expected: a larger spacing, or less height, serves");
}

void raise(Edit<CornerBlock<8>>& edit, Key corner, double distance, Attributes colour) {
  using Geometry = BlockGeometry<8>;
  const double value = std::clamp(0.5 - distance / 2, 0.0, 1.0);
  if (!(value > 0)) return;
  CornerBlock<8>& block = edit.write(Geometry::blockOf(corner));
  const auto at = static_cast<std::size_t>(Geometry::indexOf(corner));
  block.value[at] = static_cast<float>(value);
  block.attributes[at] = colour;
}

void raiseColumn(Edit<CornerBlock<8>>& edit, const Heights& heights, Key foot, Attributes colour) {
  const int i = foot.i, j = foot.j;
  const double h = heights.at(i, j);
  const double right = heights.at(i + 1, j), left = heights.at(i - 1, j);
  const double above = heights.at(i, j + 1), below = heights.at(i, j - 1);
  const double dx = 0.5 * (right - left), dy = 0.5 * (above - below);
  const double along = 1 / std::sqrt(1 + dx * dx + dy * dy);
  // Beside a cliff the slope is no measure of what lies over it.
  const double top = std::max({h, right, left, above, below});
  for (int k = -1; k <= top + 1; ++k)
    raise(edit, {i, j, k}, std::max({(k - h) * along, k - top, -double(k)}), colour);
}

// A prism with rounded edges, which cells could not show sharp: distances across and up, less the
// rounding, make a corner.
struct Letters {
  Outline outline;
  double top, rounding;

  void raiseColumn(Edit<CornerBlock<8>>& edit, Key foot, Attributes colour) const {
    const double across = outline.at(foot.i, foot.j) + rounding;
    for (int k = -1; across < rounding + 1 && k <= top + 1; ++k) {
      const double up = std::abs(k - 0.5 * top) - 0.5 * top + rounding;
      const double round = std::hypot(std::max(across, 0.0), std::max(up, 0.0));
      const double distance = std::min(std::max(across, up), 0.0) + round - rounding;
      raise(edit, {foot.i, foot.j, k}, distance, colour);
    }
  }
};

// The columns that a picture stands on.
struct Ground {
  Ground(const GreyImage& image, const ReliefOptions& options) {
    requireValid(image, options);
    const double across = options.width / options.spacing;
    const double up = across * image.height / image.width;
    pixels = image.width / across;
    white = options.height / options.spacing;
    wide = static_cast<int>(std::ceil(across / 2)) + 1;
    tall = static_cast<int>(std::ceil(up / 2)) + 1;
  }
  double pixels, white;
  int wide, tall;
};

template <class Column>
Clay columns(const Ground& ground, double spacing, Column&& column) {
  Clay clay;
  clay.scale.spacing = spacing;
  Edit<CornerBlock<8>> edit(clay.tree);
  for (int i = -ground.wide; i <= ground.wide; ++i)
    for (int j = -ground.tall; j <= ground.tall; ++j) column(edit, Key{i, j, 0});
  edit.commit();
  if (clay.tree.empty())
    throw Error("relief: nothing of the picture fills a cell of " + numberText(spacing) +
                " found, more cells, or another size, expected");
  return clay;
}

}  // namespace

Clay relief(const GreyImage& image, const ReliefOptions& options) {
  if (std::ranges::none_of(image.grey, [](float grey) { return grey > 0; }))
    throw Error("relief: a black picture found, some grey expected");
  const Ground ground(image, options);
  const Heights heights{{image, ground.pixels}, ground.white};
  const Attributes colour = packAttributes(options.colour);
  return columns(ground, options.spacing, [&](Edit<CornerBlock<8>>& edit, Key foot) {
    raiseColumn(edit, heights, foot, colour);
  });
}

Clay standingText(const GreyImage& outline, const ReliefOptions& options) {
  const Ground ground(outline, options);
  const Letters letters{
      {{outline, ground.pixels}, ground.pixels}, ground.white, std::min(1.5, ground.white / 2)};
  const Attributes colour = packAttributes(options.colour);
  return columns(ground, options.spacing, [&](Edit<CornerBlock<8>>& edit, Key foot) {
    letters.raiseColumn(edit, foot, colour);
  });
}

}  // namespace bozzetto
