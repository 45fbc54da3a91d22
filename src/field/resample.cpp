#include "bozzetto/field/resample.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "bozzetto/base/error.hpp"
#include "bozzetto/base/parallel.hpp"
#include "field/resample_ratio.hpp"
#include "field/resample_step.hpp"

namespace bozzetto {
namespace {

constexpr float kDropBelow = 1e-4f;
constexpr std::size_t kBatch = 512;  // columns between two reports

struct ProgressPart {
  Progress& progress;
  double begin, end;
};

Clay resampledOnce(const Clay& field, const ResamplePass& pass, const ProgressPart& part) {
  const std::vector<KeyRun> keys = resampledKeys(field, pass.ratio);
  Clay result{{}, field.scale};
  std::vector<std::vector<ResampledRun>> made(kBatch);
  for (std::size_t first = 0; first < keys.size(); first += kBatch) {
    const double done = static_cast<double>(first) / static_cast<double>(keys.size());
    part.progress.step("resample", part.begin + done * (part.end - part.begin));
    const std::size_t count = std::min(kBatch, keys.size() - first);
    parallelFor(count, 4, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) {
        made[n] = resampleRun(field, keys[first + n], pass);
      }
    });
    for (std::size_t n = 0; n < count; ++n) {
      for (auto& [run, block] : made[n]) result.tree.put(run.key, run.length, std::move(block));
    }
  }
  return result;
}

void requireMemory(const Clay& field, double spacing, const ResampleOptions& options) {
  const ResamplePrediction prediction = predictResample(field, spacing);
  if (prediction.bytes <= options.memoryLimit) return;
  const auto inMiB = [](std::size_t bytes) { return std::to_string(bytes >> 20) + " MiB"; };
  throw Error("resample to spacing " + std::to_string(spacing) + ": about " +
              inMiB(prediction.bytes) + " needed, at most " + inMiB(options.memoryLimit) +
              " allowed");
}

}  // namespace

Clay resample(const Clay& field, double spacing, const ResampleOptions& options,
              Progress& progress) {
  double ratio = resampleRatio(field, spacing);
  Clay result = field;
  if (ratio != 1) {
    requireMemory(field, spacing, options);
    // A tent over 2ᵐ cells is m tents over 2 cells in turn.
    int halvings = 0;
    for (; ratio > 2; ratio /= 2) ++halvings;
    double begin = 0;
    for (; halvings > 0; --halvings) {
      const double end = begin + (1 - begin) * 0.8;
      result = resampledOnce(result, {2, 0}, {progress, begin, end});
      begin = end;
    }
    result = resampledOnce(result, {ratio, kDropBelow}, {progress, begin, 1});
  }
  result.scale.spacing = spacing;
  progress.step("resample", 1);
  return result;
}

}  // namespace bozzetto
