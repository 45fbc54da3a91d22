// What programs reported, by name: ours as Google Benchmark names them, peers' as
// PEER/CASE/radius:R/threads:T.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace bozzetto::compare {

struct Sample {
  std::vector<double> ms;                              ///< one a repetition, over all rounds
  std::map<std::string, std::vector<double>> figures;  ///< counters: bytes, triangles, …
  std::vector<std::string> hashes;                     ///< different ones only
  double least = 0;                                    ///< milliseconds

  /// Median of "ms" or of a figure; nothing when it was never reported.
  std::optional<double> median(const std::string& metric) const;
  void addTime(double value);
  void addHash(const std::string& hash);
};

class Measurements {
 public:
  /// What a Google Benchmark program wrote with --benchmark_format=json.
  void addBenchmarks(const std::string& json);
  /// One object a line, as peers/report.hpp prints them.
  void addPeer(const std::string& lines);

  Sample& at(const std::string& name) { return samples_[name]; }
  const Sample* find(const std::string& name) const;
  const std::map<std::string, Sample>& all() const { return samples_; }

 private:
  std::map<std::string, Sample> samples_;
};

}  // namespace bozzetto::compare
