#include "solid/columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace bozzetto {
namespace {

// Columns are taken a hair beside their corners: places people choose lie on the grid, and a column
// through a vertex would have to be seen alike by all triangles round it.
constexpr double kAsideI = 1.618e-6, kAsideJ = 2.718e-6;

// A triangle seen along k. Two triangles with a common side agree to the bit on which side of it a
// column lies: every column crosses a closed surface as often in as out.
class Shadow {
 public:
  Shadow(const TriangleMesh& mesh, const TriangleMesh::Triangle& triangle)
      : mesh_(mesh), triangle_(triangle) {}

  template <class Callback>
  void forColumns(std::int32_t sizeI, std::int32_t sizeJ, Callback&& callback) const {
    const auto &a = at(0), &b = at(1), &c = at(2);
    const auto first = [](double x) { return std::max(0, static_cast<int>(std::ceil(x)) - 1); };
    const int i0 = first(std::min({a.x, b.x, c.x})), j0 = first(std::min({a.y, b.y, c.y}));
    const int i1 =
        std::min<int>(sizeI - 1, static_cast<int>(std::floor(std::max({a.x, b.x, c.x}))));
    const int j1 =
        std::min<int>(sizeJ - 1, static_cast<int>(std::floor(std::max({a.y, b.y, c.y}))));
    for (int i = i0; i <= i1; ++i) {
      for (int j = j0; j <= j1; ++j) {
        const std::array<bool, 3> left{leftOf(0, i, j), leftOf(1, i, j), leftOf(2, i, j)};
        if (left[0] != left[1] || left[1] != left[2]) continue;
        callback(i, j, height(i, j), left[0] ? 1 : -1);
      }
    }
  }

 private:
  const glm::dvec3& at(std::size_t n) const { return mesh_.positions[triangle_[n]]; }

  static double area(const glm::dvec3& a, const glm::dvec3& b, int i, int j) {
    return (b.x - a.x) * (j + kAsideJ - a.y) - (b.y - a.y) * (i + kAsideI - a.x);
  }

  bool leftOf(std::size_t n, int i, int j) const {
    const auto from = triangle_[n], to = triangle_[(n + 1) % 3];
    const bool turned = to < from;
    const auto &a = mesh_.positions[std::min(from, to)], &b = mesh_.positions[std::max(from, to)];
    return (area(a, b, i, j) >= 0) != turned;
  }

  double height(int i, int j) const {
    const auto &a = at(0), &b = at(1), &c = at(2);
    const double wa = area(b, c, i, j), wb = area(c, a, i, j), wc = area(a, b, i, j);
    const double sum = wa + wb + wc;
    const double mean = (a.z + b.z + c.z) / 3;
    if (sum == 0) return mean;
    return std::clamp((wa * a.z + wb * b.z + wc * c.z) / sum, std::min({a.z, b.z, c.z}),
                      std::max({a.z, b.z, c.z}));
  }

  const TriangleMesh& mesh_;
  const TriangleMesh::Triangle& triangle_;
};

}  // namespace

Columns::Columns(const TriangleMesh& mesh, std::int32_t sizeI, std::int32_t sizeJ)
    : sizeI_(sizeI), sizeJ_(sizeJ) {
  const auto forAll = [&](auto&& callback) {
    for (const auto& triangle : mesh.triangles)
      Shadow(mesh, triangle).forColumns(sizeI, sizeJ, callback);
  };
  const auto columnOf = [&](int i, int j) {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(sizeJ) + std::size_t(j);
  };
  start_.assign(columnOf(sizeI, 0) + 1, 0);
  forAll([&](int i, int j, double, int) { ++start_[columnOf(i, j) + 1]; });
  for (std::size_t n = 1; n < start_.size(); ++n) start_[n] += start_[n - 1];

  crossings_.resize(start_.back());
  std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
  // Seen from above (k up), a counter-clockwise triangle is left on the way up.
  forAll([&](int i, int j, double k, int turn) {
    crossings_[next[columnOf(i, j)]++] = {static_cast<float>(k), -turn};
  });
  for (std::size_t n = 0; n + 1 < start_.size(); ++n) {
    const auto from = crossings_.begin() + static_cast<std::ptrdiff_t>(start_[n]);
    std::sort(from, crossings_.begin() + static_cast<std::ptrdiff_t>(start_[n + 1]),
              [](const Crossing& a, const Crossing& b) { return a.k < b.k; });
  }
}

int Columns::winding(std::int32_t i, std::int32_t j, double k) const {
  int sum = 0;
  for (const Crossing& crossing : column(i, j)) {
    if (crossing.k >= k) break;
    sum += crossing.turn;
  }
  return sum;
}

std::span<const Columns::Crossing> Columns::column(std::int32_t i, std::int32_t j) const {
  if (i < 0 || j < 0 || i >= sizeI_ || j >= sizeJ_) return {};
  const auto n = static_cast<std::size_t>(i) * static_cast<std::size_t>(sizeJ_) + std::size_t(j);
  return std::span(crossings_).subspan(start_[n], start_[n + 1] - start_[n]);
}

}  // namespace bozzetto
