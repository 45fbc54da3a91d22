// The three axes, so that axis code is written once and looped.
#pragma once
#include <array>

namespace bozzetto {

enum class Axis : unsigned char { x = 0, y = 1, z = 2 };

inline constexpr std::array<Axis, 3> kAxes{Axis::x, Axis::y, Axis::z};

constexpr int index(Axis axis) { return static_cast<int>(axis); }

/// The next axis in right-handed order: x → y → z → x.
constexpr Axis next(Axis axis) { return kAxes[(index(axis) + 1) % 3]; }

}  // namespace bozzetto
