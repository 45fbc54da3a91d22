// For files with kernels that take square roots: include first. Without errno GCC turns sqrt in
// loops into vector instructions; the results are the same.
#pragma once
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("no-math-errno")
#endif
