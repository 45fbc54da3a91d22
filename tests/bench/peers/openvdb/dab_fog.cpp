// The same dab on a density: a hard ball with a ramp as OpenVDB users write it, and the very
// potential and arithmetic of our tools (Wyvill, v + s·p) on density alone.
#include <cmath>

#include "cases.hpp"
#include "leaves.hpp"

namespace bozzetto::peer {
namespace {

// Density of the brush at squared distance `d2` from its centre.
struct Ramp {
  float radius;
  float operator()(float d2) const {
    return std::max(0.f, std::min(1.f, (radius - std::sqrt(d2)) * (1.f / kHalfWidth)));
  }
};

struct Wyvill {
  float perRadius2;
  float operator()(float d2) const {
    const float u = std::min(1.f, d2 * perRadius2);
    return 1 + u * (-22.f / 9 + u * (17.f / 9 - u * (4.f / 9)));
  }
};

template <Change kChange>
struct Combine {
  float operator()(float old, float brush) const {
    return kChange == Change::add ? std::max(old, brush) : std::min(old, 1.f - brush);
  }
};

template <Change kChange>
struct Accumulate {
  float operator()(float old, float brush) const {
    const float dose = static_cast<float>(workload::kStrength) * brush;
    return kChange == Change::add ? std::min(1.f, old + dose) : std::max(0.f, old - dose);
  }
};

template <class Profile, class Blend>
void writeLeaf(Leaf& leaf, const openvdb::Vec3f& offset, Profile profile, Blend blend) {
  float* row = leaf.buffer().data();
  for (int x = 0; x < 8; ++x) {
    for (int y = 0; y < 8; ++y, row += 8) {
      const float dx = offset.x() + static_cast<float>(x), dy = offset.y() + static_cast<float>(y);
      for (int z = 0; z < 8; ++z) {
        const float dz = offset.z() + static_cast<float>(z);
        row[z] = blend(row[z], profile(dx * dx + dy * dy + dz * dz));
      }
    }
  }
  leaf.setValuesOn();
}

template <class Profile, class Blend>
void dab(FloatGrid& grid, const Brush& brush, const Reach& reach, Profile profile, Blend blend) {
  static std::vector<Leaf*> leaves;
  listLeaves(grid, brush, reach, leaves);
  forEachLeaf(leaves, brush, [&](Leaf& leaf, const openvdb::Vec3f& offset) {
    writeLeaf(leaf, offset, profile, blend);
  });
}

template <Change kChange>
constexpr float kSaturated = kChange == Change::add ? 1.f : 0.f;

// Leaves wholly inside the brush become tiles.
template <Change kChange>
void dabTiles(FloatGrid& grid, const Brush& brush) {
  dab(grid, brush,
      {brush.radius, brush.radius - kHalfWidth, kSaturated<kChange>, kChange == Change::add},
      Ramp{static_cast<float>(brush.radius)}, Combine<kChange>{});
}

// Every leaf under the brush is there and is written.
template <Change kChange>
void dabDense(FloatGrid& grid, const Brush& brush) {
  constexpr float kNever = -1;
  dab(grid, brush, {brush.radius, 0, kNever, true}, Ramp{static_cast<float>(brush.radius)},
      Combine<kChange>{});
}

template <Change kChange>
void dabWyvill(FloatGrid& grid, const Brush& brush) {
  const auto perRadius2 = static_cast<float>(1 / (brush.radius * brush.radius));
  dab(grid, brush, {brush.radius, 0, kSaturated<kChange>, true}, Wyvill{perRadius2},
      Accumulate<kChange>{});
}

template <class Dab>
Case strokeCase(const std::string& name, const FloatGrid& (*base)(), Dab dab) {
  return {name, true,
          [base, dab](const Job& job) { return measureStroke(job, base(), dab, [] {}); }};
}

template <Change kChange>
void append(std::vector<Case>& cases) {
  const std::string change = nameOf(kChange);
  cases.push_back(strokeCase("dab_" + change, levelSetBall,
                             [](FloatGrid& g, const Brush& b) { dabLevelSet(g, b, kChange); }));
  cases.push_back(strokeCase("fog_" + change, fogBall, dabTiles<kChange>));
  cases.push_back(strokeCase("fog_dense_" + change, fogBall, dabDense<kChange>));
  cases.push_back(strokeCase("fog_wyvill_" + change, fogBall, dabWyvill<kChange>));
}

}  // namespace

std::vector<Case> dabCases() {
  std::vector<Case> cases;
  append<Change::add>(cases);
  append<Change::remove>(cases);
  return cases;
}

}  // namespace bozzetto::peer
