// The only place with threads for loops. Results never depend on the thread count: a body writes
// to its own indices only, and whoever reduces does so in index order afterwards.
#pragma once
#include <cstddef>

#include "bozzetto/base/function_ref.hpp"

namespace bozzetto {

/// How many threads parallelFor may use from now on; 0 = as many as the machine has.
void setThreadCount(int threads);
int threadCount();

/// Calls body(begin, end) on disjoint ranges that cover [0, count), each at least `grain` long
/// where it can be; returns when all are done. Runs on the calling thread when count <= grain or
/// one thread is set: waking a sleeping worker costs about 20 µs. The first exception thrown by a
/// body is thrown here again.
void parallelFor(std::size_t count, std::size_t grain,
                 FunctionRef<void(std::size_t begin, std::size_t end)> body);

}  // namespace bozzetto
