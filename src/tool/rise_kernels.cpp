#include "tool/rise_kernels.hpp"

#include "tool/mass_units.hpp"

namespace bozzetto {
namespace {

BOZZETTO_KERNEL MassUnits sumKernel(const Climbers& all, float way) {
  MassUnits sum = 0;
  for (std::size_t n = 0; n < all.count; ++n)
    sum += massUnits(risen(all.value[n], all.climb[n], all.most[n], way));
  return sum;
}

BOZZETTO_KERNEL void ratesKernel(const Room& room, int count, float* climb) {
  for (int n = 0; n < count; ++n) {
    const float rate = pull(room.strength, room.curve[n], room.held[n]) * climb[n];
    const float farthest = room.value[n] + kFarthestClimb * rate;
    const auto may = lessMask(room.value[n], room.most[n]) & ~lessMask(farthest, kThinnestClay);
    climb[n] = pick(may, rate, 0.0f);
  }
}

}  // namespace

BOZZETTO_SIMD_DISPATCH(MassUnits, risenSum, sumKernel, (const Climbers& all, float way), (all, way))

BOZZETTO_SIMD_DISPATCH(void, ratesOf, ratesKernel, (const Room& room, int count, float* climb),
                       (room, count, climb))

}  // namespace bozzetto
