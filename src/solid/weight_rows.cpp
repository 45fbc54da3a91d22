#include <algorithm>

#include "bozzetto/solid/refine.hpp"

namespace bozzetto {

void WeightRows::apply(std::span<const glm::dvec3> points, std::span<glm::dvec3> result) const {
  for (std::size_t row = 0; row < rowCount(); ++row) {
    glm::dvec3 sum{0};
    for (Id n = start[row]; n < start[row + 1]; ++n) sum += weights[n] * points[columns[n]];
    result[row] = sum;
  }
}

WeightRows WeightRows::transposed() const {
  WeightRows result;
  result.columnCount = rowCount();
  result.start.assign(columnCount + 1, 0);
  for (const Id column : columns) ++result.start[column + 1];
  for (std::size_t n = 0; n < columnCount; ++n) result.start[n + 1] += result.start[n];
  std::vector<Id> next(result.start.begin(), result.start.end() - 1);
  result.columns.resize(columns.size());
  result.weights.resize(columns.size());
  for (Id row = 0; row < rowCount(); ++row) {
    for (Id n = start[row]; n < start[row + 1]; ++n) {
      const Id place = next[columns[n]]++;
      result.columns[place] = row;
      result.weights[place] = weights[n];
    }
  }
  return result;
}

WeightRows WeightRows::after(const WeightRows& inner) const {
  WeightRows result;
  result.columnCount = inner.columnCount;
  std::vector<double> sums(inner.columnCount, 0);
  std::vector<std::uint8_t> seen(inner.columnCount, 0);
  std::vector<Id> touched;
  for (std::size_t row = 0; row < rowCount(); ++row) {
    touched.clear();
    for (Id n = start[row]; n < start[row + 1]; ++n) {
      const Id middle = columns[n];
      for (Id m = inner.start[middle]; m < inner.start[middle + 1]; ++m) {
        const Id column = inner.columns[m];
        if (seen[column] == 0) touched.push_back(column);
        seen[column] = 1;
        sums[column] += weights[n] * inner.weights[m];
      }
    }
    std::ranges::sort(touched);
    for (const Id column : touched) {
      result.columns.push_back(column);
      result.weights.push_back(sums[column]);
      sums[column] = 0;
      seen[column] = 0;
    }
    result.start.push_back(static_cast<Id>(result.columns.size()));
  }
  return result;
}

}  // namespace bozzetto
