// peer_openvdb: what OpenVDB 10 needs for the jobs that our benchmarks do. See
// tests/bench/NOTES.md.
#include <tbb/global_control.h>

#include <exception>

#include "cases.hpp"

namespace bozzetto::peer {
namespace {

std::vector<Case> allCases() {
  std::vector<Case> all;
  for (auto family : {dabCases, smoothCases, meshCases, fileCases}) {
    for (Case& one : family()) all.push_back(std::move(one));
  }
  return all;
}

void runCase(const Case& one, const Options& options) {
  if (!one.hasRadius) {
    print("openvdb", options, one.run({one.name, 0, options.repeats}));
    return;
  }
  for (const double radius : workload::kRadii) {
    if (options.radius != 0 && options.radius != radius) continue;
    print("openvdb", options, one.run({one.name, radius, options.repeats}));
  }
}

void run(const Options& options) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(options.threads));
  openvdb::initialize();
  for (const Case& one : allCases()) {
    if (one.name.rfind(options.only, 0) != 0) continue;
    if (options.list) {
      std::puts(one.name.c_str());
    } else {
      runCase(one, options);
    }
  }
}

}  // namespace
}  // namespace bozzetto::peer

int main(int count, char** arguments) {
  try {
    bozzetto::peer::run(bozzetto::peer::parseOptions(count, arguments));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "peer_openvdb: %s\n", error.what());
    return 1;
  }
}
