#include "table.hpp"

#include <cstdio>

namespace bozzetto::compare {
namespace {

std::string replaced(std::string text, const std::string& mark, int value) {
  for (auto at = text.find(mark); at != std::string::npos; at = text.find(mark)) {
    text.replace(at, mark.size(), std::to_string(value));
  }
  return text;
}

bool hasMark(const Aim& aim, const std::string& mark) {
  return aim.ours.name.find(mark) != std::string::npos;
}

// One line of an aim's table.
struct Row {
  const Aim& aim;
  int radius = 0, threads = 0;
  double factor = kNoAim;

  std::string nameOf(const Figure& figure) const {
    return replaced(replaced(figure.name, "{r}", radius), "{t}", threads);
  }
};

std::vector<Row> rowsOf(const Aim& aim) {
  const std::size_t radii = hasMark(aim, "{r}") ? kRadii.size() : 1;
  const std::size_t threads = hasMark(aim, "{t}") ? kThreads.size() : 1;
  std::vector<Row> rows;
  for (std::size_t t = 0; t < threads; ++t) {
    for (std::size_t r = 0; r < radii; ++r) {
      rows.push_back({aim, radii > 1 ? kRadii[r] : 0, threads > 1 ? kThreads[t] : 0,
                      aim.factors[r % aim.factors.size()]});
    }
  }
  return rows;
}

std::string verdictOn(double reached, double factor, Tally& tally) {
  if (factor == kNoAim) return "";
  char text[64];
  const bool met = reached >= factor;
  if (met) {
    std::snprintf(text, sizeof text, "aim %.3g: met", factor);
  } else {
    std::snprintf(text, sizeof text, "aim %.3g: missed by %.3g", factor, factor / reached);
  }
  ++(met ? tally.met : tally.missed);
  return text;
}

std::string hashOf(const Sample& sample) {
  if (sample.hashes.empty()) return "";
  return sample.hashes.size() == 1 ? sample.hashes.front() : "DIFFERS BETWEEN RUNS";
}

void printFigure(const Sample& sample, const std::string& metric) {
  const double value = *sample.median(metric);
  if (metric == "ms") {
    std::printf(" %11.4f (%9.4f)", value, sample.least);
  } else {
    std::printf(" %23.0f", value);
  }
}

void printRow(const Row& row, const Measurements& measurements, Tally& tally) {
  const Sample* ours = measurements.find(row.nameOf(row.aim.ours));
  const Sample* theirs = measurements.find(row.nameOf(row.aim.theirs));
  std::printf("%6d %4d", row.radius, row.threads);
  const auto value = ours ? ours->median(row.aim.ours.metric) : std::nullopt;
  const auto other = theirs ? theirs->median(row.aim.theirs.metric) : std::nullopt;
  if (!value || !other) {
    const Figure& missing = value ? row.aim.theirs : row.aim.ours;
    std::printf("  not measured: %s\n", row.nameOf(missing).c_str());
    tally.absent += row.factor != kNoAim;
    return;
  }
  printFigure(*ours, row.aim.ours.metric);
  printFigure(*theirs, row.aim.theirs.metric);
  const double reached = *other / *value;
  std::printf(" %8.2f  %-28s %s\n", reached, verdictOn(reached, row.factor, tally).c_str(),
              hashOf(*ours).c_str());
}

bool anyMeasured(const Aim& aim, const Measurements& measurements) {
  for (const Row& row : rowsOf(aim)) {
    if (measurements.find(row.nameOf(row.aim.theirs)) != nullptr) return true;
  }
  return false;
}

}  // namespace

void printAim(const Aim& aim, const Measurements& measurements, Tally& tally) {
  if (!anyMeasured(aim, measurements)) {
    std::printf("\n%s\n  not measured in this run\n", aim.title.c_str());
    for (const Row& row : rowsOf(aim)) tally.absent += row.factor != kNoAim;
    return;
  }
  const char* unit = aim.ours.metric == "ms" ? "median (least) ms" : aim.ours.metric.c_str();
  std::printf("\n%s\nradius  thr %23s %23s    times as good\n", aim.title.c_str(), unit, "theirs");
  for (const Row& row : rowsOf(aim)) printRow(row, measurements, tally);
}

void printAll(const Measurements& measurements) {
  std::printf("\nEverything: median (least) ms, hash, counters\n");
  for (const auto& [name, sample] : measurements.all()) {
    if (name.rfind("record/", 0) == 0) continue;
    std::printf("%-44s %11.4f (%9.4f) %16s", name.c_str(), sample.median("ms").value_or(0),
                sample.least, hashOf(sample).c_str());
    for (const auto& [figure, values] : sample.figures) {
      std::printf(" %s=%.6g", figure.c_str(), sample.median(figure).value_or(0));
    }
    std::printf("\n");
  }
}

}  // namespace bozzetto::compare
