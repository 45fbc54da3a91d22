// How a benchmark program names and registers its rows, and its main function.
#pragma once
#include <benchmark/benchmark.h>

#include <string>

namespace bozzetto::rows {

/// "whole_dab/radius:8/side:8/threads:1", as bench_compare reads it.
inline std::string nameOf(const std::string& what, double radius, int side, int threads) {
  return what + "/radius:" + std::to_string(static_cast<int>(radius)) +
         "/side:" + std::to_string(side) + "/threads:" + std::to_string(threads);
}

/// Bodies time themselves (SetIterationTime): what they prepare does not count.
template <class Body, class... Arguments>
benchmark::internal::Benchmark* add(const std::string& name, Body body, Arguments... arguments) {
  return benchmark::RegisterBenchmark(name.c_str(), body, arguments...)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
}

/// Runs what `addAll` registered; the program's exit code.
inline int run(void (*addAll)(), int count, char** arguments) {
  addAll();
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

}  // namespace bozzetto::rows
