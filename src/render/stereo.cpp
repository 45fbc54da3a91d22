#include "bozzetto/render/stereo.hpp"

#include "render/names.hpp"

namespace bozzetto {

StereoMode parseStereo(std::string_view name) {
  using enum StereoMode;
  return parseName<StereoMode>("stereo", name,
                               {{"off", off},
                                {"side-by-side", sideBySide},
                                {"rows", rowInterlaced},
                                {"anaglyph", anaglyph},
                                {"quad-buffer", quadBuffer}});
}

EyeShift eyeShift(const Camera& camera, const Stereo& stereo, Eye eye) {
  if (stereo.mode == StereoMode::off) return {};
  const double plane = stereo.zeroParallax * camera.distance;
  const double half = stereo.eyeDistance * plane / 2;
  return {eye == Eye::left ? -half : half, plane};
}

}  // namespace bozzetto
