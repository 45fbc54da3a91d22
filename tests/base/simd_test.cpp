// Both copies of a kernel give the same bits, and the plain one can be had on any machine.
#include "bozzetto/base/simd.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

namespace bozzetto {
namespace {

BOZZETTO_KERNEL float blendedSum(const float* a, const float* b, int count) {
  float lanes[8] = {};
  for (int n = 0; n + 8 <= count; n += 8)
    for (int lane = 0; lane < 8; ++lane)
      lanes[lane] += a[n + lane] * b[n + lane] + std::sqrt(a[n + lane]);
  float sum = 0;
  for (const float lane : lanes) sum += lane;
  return sum;
}

BOZZETTO_SIMD_DISPATCH(float, dispatchedSum, blendedSum, (const float* a, const float* b, int n),
                       (a, b, n))

class Simd : public testing::Test {
 protected:
  void TearDown() override { forbidSimd(false); }
};

TEST_F(Simd, CanBeForbiddenAndAllowedAgain) {
  const bool machine = hasAvx2();
  forbidSimd(true);
  EXPECT_FALSE(hasAvx2());
  forbidSimd(false);
  EXPECT_EQ(hasAvx2(), machine);
}

TEST_F(Simd, BothCopiesGiveTheSameBits) {
  std::vector<float> a(4096), b(4096);
  for (std::size_t n = 0; n < a.size(); ++n) {
    a[n] = std::fabs(std::sin(static_cast<float>(n)) * 1e3f);
    b[n] = std::cos(static_cast<float>(3 * n)) * 1e-2f;
  }
  const float fast = dispatchedSum(a.data(), b.data(), 4096);
  forbidSimd(true);
  const float plain = dispatchedSum(a.data(), b.data(), 4096);
  EXPECT_EQ(std::memcmp(&fast, &plain, sizeof(float)), 0) << fast << " and " << plain;
}

}  // namespace
}  // namespace bozzetto
