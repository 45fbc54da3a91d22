// What every peer program shares: its command line, its clock, and one JSON object a line that
// bench_compare reads.
#pragma once
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "workload.hpp"

namespace bozzetto::peer {

struct Options {
  std::string only;   ///< run cases whose name begins so; empty = all
  double radius = 0;  ///< run this tool radius; 0 = all
  int threads = 1;    ///< at most so many
  int repeats = 5;    ///< of each measurement
  bool list = false;  ///< name the cases and stop
};

/// --case PREFIX  --radius R  --threads N  --repeats N  --list
inline Options parseOptions(int count, char** arguments) {
  Options options;
  for (int n = 1; n < count; ++n) {
    const std::string name = arguments[n];
    if (name == "--list") {
      options.list = true;
      continue;
    }
    if (++n == count) throw std::runtime_error(name + " needs a value");
    const std::string value = arguments[n];
    if (name == "--case")
      options.only = value;
    else if (name == "--radius")
      options.radius = std::stod(value);
    else if (name == "--threads")
      options.threads = std::stoi(value);
    else if (name == "--repeats")
      options.repeats = std::stoi(value);
    else
      throw std::runtime_error("unknown option " + name);
  }
  return options;
}

class Clock {
 public:
  double ms() const { return (workload::seconds() - start_) * 1e3; }

 private:
  double start_ = workload::seconds();
};

/// Milliseconds of `repeats` runs of `body`, each after an untimed `prepare`.
template <class Prepare, class Body>
std::vector<double> timeRepeats(int repeats, Prepare prepare, Body body) {
  std::vector<double> ms;
  for (int n = 0; n < repeats; ++n) {
    prepare();
    const Clock clock;
    body();
    ms.push_back(clock.ms());
  }
  return ms;
}

inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  if (values.empty()) return 0;
  return values.size() % 2 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

/// FNV-1a over 32-bit words: tells whether two runs gave the same result.
class Fingerprint {
 public:
  void add(std::uint32_t word) { value_ = (value_ ^ word) * 0x100000001b3u; }
  void add(const float* values, std::size_t count) {
    for (std::size_t n = 0; n < count; ++n) {
      std::uint32_t word;
      std::memcpy(&word, values + n, sizeof word);
      add(word);
    }
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

struct Result {
  std::string name;        ///< of the case
  double radius = 0;       ///< of the tool; 0 = has none
  std::vector<double> ms;  ///< one a repeat
  std::uint64_t fingerprint = 0;
  std::vector<std::pair<const char*, double>> detail;  ///< counts and bytes
};

inline void print(const char* peer, const Options& options, const Result& result) {
  const double least =
      result.ms.empty() ? 0 : *std::min_element(result.ms.begin(), result.ms.end());
  std::printf(R"({"peer":"%s","case":"%s","radius":%g,"threads":%d,"median_ms":%.6g,)", peer,
              result.name.c_str(), result.radius, options.threads, median(result.ms));
  std::printf(R"("min_ms":%.6g,"hash":"%016llx","detail":{)", least,
              static_cast<unsigned long long>(result.fingerprint));
  const char* comma = "";
  for (const auto& [key, value] : result.detail) {
    std::printf(R"(%s"%s":%.10g)", comma, key, value);
    comma = ",";
  }
  std::printf("}}\n");
  std::fflush(stdout);
}

}  // namespace bozzetto::peer
