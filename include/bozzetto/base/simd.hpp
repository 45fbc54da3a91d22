// One kernel, two instruction sets. A kernel is an always-inline function; BOZZETTO_SIMD_KERNEL
// makes a plain and an AVX2 copy of it and a dispatcher that picks once. Both give the same bits:
// no fused multiply-add, no reassociation.
#pragma once

namespace bozzetto {

/// True when the machine has AVX2 and the environment does not forbid it (BOZZETTO_SIMD=scalar).
bool hasAvx2();

/// For tests: run the plain copies although the machine could do more.
void forbidSimd(bool forbid);

}  // namespace bozzetto

#if defined(__x86_64__)
#define BOZZETTO_TARGET_AVX2 [[gnu::target("avx2")]]
#else
#define BOZZETTO_TARGET_AVX2
#endif

#define BOZZETTO_KERNEL [[gnu::always_inline]] inline

// Defines `name(args)` that calls `body(args)` compiled for the best instruction set at hand.
#define BOZZETTO_SIMD_DISPATCH(result, name, body, parameters, arguments)             \
  BOZZETTO_TARGET_AVX2 static result name##Avx2 parameters { return body arguments; } \
  static result name##Plain parameters { return body arguments; }                     \
  result name parameters {                                                            \
    return ::bozzetto::hasAvx2() ? name##Avx2 arguments : name##Plain arguments;      \
  }
