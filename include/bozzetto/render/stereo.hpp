// Two eyes: what they see apart, and how one picture carries both (Ferley §2, §5).
#pragma once
#include <string_view>

#include "bozzetto/render/camera.hpp"

namespace bozzetto {

enum class StereoMode {
  off,
  sideBySide,     ///< left half for the left eye, each squeezed to half its width
  rowInterlaced,  ///< even rows from the top for the left eye
  anaglyph,       ///< red for the left eye, green and blue for the right
  quadBuffer,     ///< left and right back buffer of the framebuffer, where it has them
};

/// The name on the command line → mode. Throws Error naming the choices.
StereoMode parseStereo(std::string_view name);

struct Stereo {
  StereoMode mode = StereoMode::off;
  double eyeDistance = 1 / 30.0;  ///< of the distance to the plane of zero parallax
  double zeroParallax = 1;        ///< of the camera's distance: what lies there is on the screen
  friend bool operator==(const Stereo&, const Stereo&) = default;
};

enum class Eye { left, right };

/// How one eye stands beside the camera: it looks the same way through the same window at the
/// plane of zero parallax, so that the frustum is off its axis and nothing is turned inwards.
struct EyeShift {
  double sideways = 0;  ///< cells to the right
  double plane = 0;     ///< distance of the plane of zero parallax, cells; 0: none, no shift
  friend bool operator==(const EyeShift&, const EyeShift&) = default;
};
EyeShift eyeShift(const Camera& camera, const Stereo& stereo, Eye eye);

}  // namespace bozzetto
