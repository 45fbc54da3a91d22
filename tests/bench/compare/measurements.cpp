#include "measurements.hpp"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

namespace bozzetto::compare {
namespace {

using Json = nlohmann::json;

double toMs(double time, const std::string& unit) {
  if (unit == "ns") return time * 1e-6;
  if (unit == "us") return time * 1e-3;
  return unit == "s" ? time * 1e3 : time;
}

std::optional<double> medianOf(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

// Numbers of a benchmark that are not its own counters.
bool isBookkeeping(const std::string& key) {
  static const std::set<std::string> kKeys{"family_index",     "per_family_instance_index",
                                           "repetitions",      "repetition_index",
                                           "threads",          "iterations",
                                           "real_time",        "cpu_time",
                                           "items_per_second", "bytes_per_second"};
  return kKeys.count(key) != 0;
}

// Benchmarks with settings of their own carry them behind the name.
std::string plainName(std::string name) {
  for (const char* ending : {"/manual_time", "/real_time", "/iterations:", "/repeats:"}) {
    if (const auto place = name.find(ending); place != std::string::npos) name.resize(place);
  }
  return name;
}

void addBenchmark(const Json& one, Measurements& to) {
  if (one.value("run_type", "iteration") != "iteration") return;
  if (one.value("error_occurred", false)) {
    std::fprintf(stderr, "%s: %s\n", one.value("name", "").c_str(),
                 one.value("error_message", "failed").c_str());
    return;
  }
  Sample& sample = to.at(plainName(one.value("run_name", one.value("name", ""))));
  sample.addTime(toMs(one.at("real_time").get<double>(), one.value("time_unit", "ns")));
  if (one.contains("label")) sample.addHash(one["label"].get<std::string>());
  for (const auto& [key, value] : one.items()) {
    if (value.is_number() && !isBookkeeping(key)) sample.figures[key].push_back(value);
  }
}

std::string peerName(const Json& one) {
  std::ostringstream name;
  name << one.at("peer").get<std::string>() << '/' << one.at("case").get<std::string>();
  if (const double radius = one.at("radius"); radius != 0) name << "/radius:" << radius;
  name << "/threads:" << one.at("threads").get<int>();
  return name.str();
}

}  // namespace

std::optional<double> Sample::median(const std::string& metric) const {
  if (metric == "ms") return medianOf(ms);
  const auto found = figures.find(metric);
  return found == figures.end() ? std::nullopt : medianOf(found->second);
}

void Sample::addTime(double value) {
  least = ms.empty() ? value : std::min(least, value);
  ms.push_back(value);
}

void Sample::addHash(const std::string& hash) {
  if (std::find(hashes.begin(), hashes.end(), hash) == hashes.end()) hashes.push_back(hash);
}

void Measurements::addBenchmarks(const std::string& json) {
  const Json document = Json::parse(json);
  for (const Json& one : document.at("benchmarks")) addBenchmark(one, *this);
}

void Measurements::addPeer(const std::string& lines) {
  std::istringstream stream(lines);
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line.front() != '{') continue;
    const Json one = Json::parse(line);
    Sample& sample = at(peerName(one));
    sample.addTime(one.at("median_ms"));
    sample.least = std::min(sample.least, one.at("min_ms").get<double>());
    sample.addHash(one.value("hash", ""));
    for (const auto& [key, value] : one.at("detail").items()) sample.figures[key].push_back(value);
  }
}

const Sample* Measurements::find(const std::string& name) const {
  const auto found = samples_.find(name);
  return found == samples_.end() ? nullptr : &found->second;
}

}  // namespace bozzetto::compare
