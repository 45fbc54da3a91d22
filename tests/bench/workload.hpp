// What every benchmark and every peer does: the ball, the stroke on it, the radii, the dense
// gyroid. Plain C++, so that programs which link none of our modules share it (C++17: VTK 9.1 reads
// no newer).
#pragma once
#include <time.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <vector>

namespace bozzetto::workload {

/// Seconds, for differences. BOZZETTO_BENCH_CLOCK=cpu counts what the process itself worked instead
/// of the time on the wall: for single-thread figures on a machine that others use too.
inline double seconds() {
  static const char* wanted = std::getenv("BOZZETTO_BENCH_CLOCK");
  static const bool cpu = wanted != nullptr && std::strcmp(wanted, "cpu") == 0;
  timespec now{};
  clock_gettime(cpu ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

using Point = std::array<double, 3>;

inline constexpr double kBallRadius = 256;  ///< cells; the ball is centred on the origin
inline constexpr double kSlope = 3;         ///< cells over which the ball's value falls from 1 to 0
inline constexpr int kDabs = 50;            ///< in a stroke
inline constexpr double kStrength = 0.5;    ///< of a dab

inline constexpr std::array<double, 5> kRadii{8, 16, 32, 64, 128};  ///< of the tool, cells

/// Density of the ball at a point: ½ on its surface.
inline float ballDensity(double x, double y, double z, double radius = kBallRadius) {
  const double outside = std::sqrt(x * x + y * y + z * z) - radius;
  const double value = 0.5 - outside / kSlope;
  return static_cast<float>(value < 0 ? 0 : value > 1 ? 1 : value);
}

inline Point unit(const Point& p) {
  const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
  return {p[0] / length, p[1] / length, p[2] / length};
}

/// Dab centres on a great circle of the ball, a quarter of the tool's radius apart, tilted so that
/// no axis helps.
inline std::vector<Point> stroke(double toolRadius, int dabs = kDabs) {
  const Point from = unit({1, 0.2, 0.1});
  const Point leaning{-0.3, 1, 0.4};
  const double along = from[0] * leaning[0] + from[1] * leaning[1] + from[2] * leaning[2];
  const Point to = unit(
      {leaning[0] - along * from[0], leaning[1] - along * from[1], leaning[2] - along * from[2]});
  std::vector<Point> centres(static_cast<std::size_t>(dabs));
  for (int n = 0; n < dabs; ++n) {
    const double angle = n * (toolRadius / 4) / kBallRadius;
    const double c = kBallRadius * std::cos(angle), s = kBallRadius * std::sin(angle);
    centres[static_cast<std::size_t>(n)] = {c * from[0] + s * to[0], c * from[1] + s * to[1],
                                            c * from[2] + s * to[2]};
  }
  return centres;
}

inline constexpr int kGyroidSide = 256;  ///< samples along each axis, 8 periods

/// The gyroid at a sample of the dense cube; the surface is at 0, values lie in [-1.5, 1.5].
inline float gyroid(int x, int y, int z) {
  const float centre = 0.5f * (kGyroidSide - 1);
  const float wave = 2 * 3.14159265f * 8 / kGyroidSide;
  const float a = (static_cast<float>(x) - centre) * wave;
  const float b = (static_cast<float>(y) - centre) * wave;
  const float c = (static_cast<float>(z) - centre) * wave;
  return std::sin(a) * std::cos(b) + std::sin(b) * std::cos(c) + std::sin(c) * std::cos(a);
}

}  // namespace bozzetto::workload
