#include "bozzetto/tool/stamp.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "bozzetto/base/error.hpp"
#include "tool/float_bits.hpp"

namespace bozzetto {
namespace {

constexpr double kNarrowest = 0.01;

void requireFinite(double number, const char* what) {
  if (std::isfinite(number)) return;
  throw Error(std::string("stamp ") + what + ": not a finite number");
}

template <class Cubic>
struct Rim {
  Cubic rising, falling;
  double surface, rise, fall, widening;
};

template <class Cubic>
BOZZETTO_KERNEL void bulgeBody(const Rim<Cubic>& rim, const float* depth, int count, float* def) {
  for (int n = 0; n < count; ++n) {
    const double x = (static_cast<double>(depth[n]) - rim.surface) / rim.widening;
    const double past = positive(x - rim.rise);
    const double falls = pick(lessMask(past, rim.fall), rim.falling(past), 0.0);
    const double rises = pick(lessMask(positive(x), rim.rise), rim.rising(x), falls);
    const double outside = pick(signMask(bits(x)), 0.0, rises);
    def[n] = static_cast<float>(lesser(positive(outside), 1.0));
  }
}

template <class Cubic>
BOZZETTO_TARGET_AVX2 void bulgeAvx2(const Rim<Cubic>& rim, const float* depth, int count,
                                    float* def) {
  bulgeBody(rim, depth, count, def);
}

template <class Cubic>
void bulgePlain(const Rim<Cubic>& rim, const float* depth, int count, float* def) {
  bulgeBody(rim, depth, count, def);
}

}  // namespace

StampOptions clamped(const StampOptions& options, double iso) {
  requireFinite(options.height, "height");
  requireFinite(options.rise, "rise");
  requireFinite(options.fall, "fall");
  requireFinite(options.slope, "slope");
  const double surface = 1 - iso;
  StampOptions made = options;
  made.height = std::clamp(made.height, 0.0, 1.0);
  made.rise = std::clamp(made.rise, kNarrowest, 4.0);
  made.fall = std::clamp(made.fall, kNarrowest, 4.0);
  const double room = 1 - surface, wide = made.rise + made.fall;
  if (made.profile == StampProfile::paper && wide > room) {
    made.rise *= room / wide;
    made.fall *= room / wide;
  }
  const double steepest = std::min(3 * made.height / made.rise, 3 / surface);
  made.slope = std::clamp(made.slope, 0.0, steepest);
  return made;
}

StampCurve::StampCurve(const StampOptions& options, double iso) : surface_(1 - iso) {
  const StampOptions made = clamped(options, iso);
  const double s = surface_, m = rise_ = made.rise, r = fall_ = made.fall;
  const double n = made.height, g = made.slope;
  inside_ = {(g * s - 2) / (s * s * s), (3 - g * s) / (s * s), 0, -1};
  rising_ = {(g * m - 2 * n) / (m * m * m), (3 * n - 2 * g * m) / (m * m), g, 0};
  falling_ = {2 * n / (r * r * r), -3 * n / (r * r), 0, n};
}

double StampCurve::operator()(double d) const {
  if (d <= 0) return -1;
  if (d < surface_) return inside_(d);
  d -= surface_;
  if (d < rise_) return rising_(d);
  d -= rise_;
  return d < fall_ ? falling_(d) : 0;
}

void StampCurve::bulge(const float* depth, int count, double widening, float* def) const {
  const Rim<Cubic> rim{rising_, falling_, surface_, rise_, fall_, widening};
  hasAvx2() ? bulgeAvx2(rim, depth, count, def) : bulgePlain(rim, depth, count, def);
}

}  // namespace bozzetto
