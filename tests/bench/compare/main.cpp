// bench_compare: runs our benchmarks and their peers turn by turn, and says which aims are met.
//   --rounds N       how often every program runs that has a peer (default 1); others run once
//   --repeats N      repetitions inside a run (default 1)
//   --only TEXT      contests whose program of ours contains TEXT
//   --threads N      1 or 2 only
#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>

#include "aims.hpp"
#include "process.hpp"
#include "table.hpp"

namespace bozzetto::compare {
namespace {

namespace fs = std::filesystem;

struct Options {
  fs::path folder;  ///< where the programs are
  int rounds = 1;
  int repeats = 1;
  std::string only;
  int threads = 0;  ///< 0 = both
};

Options parseOptions(int count, char** arguments) {
  Options options;
  options.folder = fs::canonical("/proc/self/exe").parent_path();
  for (int n = 1; n < count; ++n) {
    const std::string name = arguments[n];
    if (++n == count) throw std::runtime_error(name + " needs a value");
    const std::string value = arguments[n];
    if (name == "--rounds")
      options.rounds = std::stoi(value);
    else if (name == "--repeats")
      options.repeats = std::stoi(value);
    else if (name == "--only")
      options.only = value;
    else if (name == "--threads")
      options.threads = std::stoi(value);
    else
      throw std::runtime_error("unknown option " + name);
  }
  return options;
}

void runOurs(const Options& options, const std::string& program, int threads, Measurements& to) {
  // A row is a whole stroke of 50 dabs or a whole body: few are enough, once memory was touched.
  // Benchmarks that do not name their threads run with the first lot.
  const std::string filter = threads == 1 ? "-threads:2" : "threads:2";
  const auto output = outputOf(options.folder / program,
                               {"--benchmark_format=json", "--benchmark_filter=" + filter,
                                "--benchmark_min_time=0.02", "--benchmark_min_warmup_time=0.001",
                                "--benchmark_repetitions=" + std::to_string(options.repeats)});
  if (output && !output->empty()) to.addBenchmarks(*output);
}

void runPeer(const Options& options, const std::string& program, const std::string& cases,
             int threads, Measurements& to) {
  // The first repetition pays for the program's start: a median needs three.
  const std::string repeats = std::to_string(std::max(3, options.repeats));
  const auto output =
      outputOf(options.folder / program,
               {"--case", cases, "--threads", std::to_string(threads), "--repeats", repeats});
  if (output) to.addPeer(*output);
}

void runContest(const Options& options, const Contest& contest, int threads, Measurements& to) {
  if (!fs::exists(options.folder / contest.program)) return;
  runOurs(options, contest.program, threads, to);
  for (const auto& [program, cases] : contest.opponents) {
    if (fs::exists(options.folder / program)) runPeer(options, program, cases, threads, to);
  }
}

Measurements measure(const Options& options) {
  Measurements measurements;
  for (int round = 0; round < options.rounds; ++round) {
    for (const Contest& contest : contests()) {
      if (contest.program.find(options.only) == std::string::npos) continue;
      if (contest.opponents.empty() && round > 0) continue;
      for (const int threads : kThreads) {
        if (options.threads != 0 && options.threads != threads) continue;
        std::fprintf(stderr, "round %d of %d: %s, threads %d\n", round + 1, options.rounds,
                     contest.program.c_str(), threads);
        runContest(options, contest, threads, measurements);
      }
    }
  }
  return measurements;
}

std::string firstLineWith(const char* file, const std::string& beginning) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind(beginning, 0) == 0) return line;
  }
  return {};
}

// A run on a busy machine says so.
void printConditions() {
  std::printf("%s\nload averages %s\n", firstLineWith("/proc/cpuinfo", "model name").c_str(),
              firstLineWith("/proc/loadavg", "").c_str());
}

int run(const Options& options) {
  printConditions();
  Measurements measurements = measure(options);
  printConditions();
  printAll(measurements);
  addBlenderOfRecord(measurements);
  Tally tally;
  for (const Aim& aim : aims()) printAim(aim, measurements, tally);
  std::printf("\naims: %d met, %d missed, %d not measured\n", tally.met, tally.missed,
              tally.absent);
  return measurements.all().empty() ? 1 : 0;
}

}  // namespace
}  // namespace bozzetto::compare

int main(int count, char** arguments) {
  using namespace bozzetto::compare;
  try {
    return run(parseOptions(count, arguments));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_compare: %s\n", error.what());
    return 2;
  }
}
