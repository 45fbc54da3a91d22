// Linear light, as glTF wants vertex colours, from and to sRGB (IEC 61966-2-1).
#pragma once
#include <cmath>

namespace bozzetto {

inline double linearFromSrgb(double c) {
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

inline double srgbFromLinear(double c) {
  return c <= 0.0031308 ? c * 12.92 : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

}  // namespace bozzetto
