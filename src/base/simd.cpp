#include "bozzetto/base/simd.hpp"

#include <atomic>
#include <cstdlib>
#include <string_view>

namespace bozzetto {
namespace {

bool detect() {
#if defined(__x86_64__)
  const char* wish = std::getenv("BOZZETTO_SIMD");
  if (wish != nullptr && std::string_view(wish) == "scalar") return false;
  return __builtin_cpu_supports("avx2") != 0;
#else
  return false;
#endif
}

std::atomic<bool> forbidden{false};

}  // namespace

bool hasAvx2() {
  static const bool detected = detect();
  return detected && !forbidden.load(std::memory_order_relaxed);
}

void forbidSimd(bool forbid) { forbidden = forbid; }

}  // namespace bozzetto
