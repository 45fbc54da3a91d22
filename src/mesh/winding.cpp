#include "bozzetto/mesh/winding.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <numeric>
#include <vector>

namespace bozzetto {
namespace {

constexpr std::size_t kLeafTriangles = 4;
// A cluster counts as one beyond this many of its radii (Barill's β).
constexpr double kFar = 2.3;
constexpr double kSolidAngle = 4 * std::numbers::pi;

// Of a cubic form Σ n_i δ_j δ_k, the coefficients of x³ y³ z³ x²y x²z y²x y²z z²x z²y xyz.
using CubicForm = std::array<double, 10>;

double valueOf(const CubicForm& c, const glm::dvec3& r) {
  const double x = r.x, y = r.y, z = r.z;
  return x * x * (c[0] * x + c[3] * y + c[4] * z) + y * y * (c[1] * y + c[5] * x + c[6] * z) +
         z * z * (c[2] * z + c[7] * x + c[8] * y) + c[9] * x * y * z;
}

// What a cluster of triangles is from afar: moments about its middle, to second order. δ is a
// place on a triangle from the middle, n its normal; integrals run over all its triangles.
struct Cluster {
  glm::dvec3 middle{0};                ///< mean of the triangles' centroids by area
  double farSquared = 0;               ///< (β · radius)²
  glm::dvec3 dipole{0};                ///< ∫ n
  double trace = 0;                    ///< ∫ n·δ
  glm::dvec3 diagonal{0}, mixed{0};    ///< of ∫ (r·n)(r·δ): xx yy zz and yz zx xy coefficients
  glm::dvec3 linear{0};                ///< ∫ 2 (n·δ) δ + (δ·δ) n
  CubicForm cubic{};                   ///< ∫ (r·n)(r·δ)²
  std::uint32_t first = 0, count = 0;  ///< triangles of a leaf
  std::uint32_t right = 0;             ///< second child; the first child is the next node

  // ∫ n·f(r + δ) with f(r) = r/|r|³ in its Taylor series (Barill eq. 9 and appendix).
  double windingFrom(const glm::dvec3& r, double squared) const {
    const double inverse = 1 / squared, cubed = inverse / std::sqrt(squared);
    const double quadratic =
        glm::dot(r * r, diagonal) + r.y * r.z * mixed.x + r.z * r.x * mixed.y + r.x * r.y * mixed.z;
    const double lower = glm::dot(r, dipole) + trace - 3 * inverse * quadratic;
    const double upper = inverse * (-1.5 * glm::dot(linear, r) + 7.5 * inverse * valueOf(cubic, r));
    return cubed * (lower + upper);
  }

  // Adds a triangle given by its area normal, its centroid from the middle, and ∫ δδᵀ / area.
  void add(const glm::dvec3& n, const glm::dvec3& c, const glm::dmat3& s) {
    dipole += n;
    trace += glm::dot(n, c);
    diagonal += n * c;
    mixed += glm::dvec3(n.y * c.z + n.z * c.y, n.z * c.x + n.x * c.z, n.x * c.y + n.y * c.x);
    linear += 2.0 * (s * n) + (s[0][0] + s[1][1] + s[2][2]) * n;
    cubic[0] += n.x * s[0][0];
    cubic[1] += n.y * s[1][1];
    cubic[2] += n.z * s[2][2];
    cubic[3] += n.y * s[0][0] + 2 * n.x * s[0][1];
    cubic[4] += n.z * s[0][0] + 2 * n.x * s[0][2];
    cubic[5] += n.x * s[1][1] + 2 * n.y * s[0][1];
    cubic[6] += n.z * s[1][1] + 2 * n.y * s[1][2];
    cubic[7] += n.x * s[2][2] + 2 * n.z * s[0][2];
    cubic[8] += n.y * s[2][2] + 2 * n.z * s[1][2];
    cubic[9] += 2 * (n.x * s[1][2] + n.y * s[0][2] + n.z * s[0][1]);
  }
};

struct Corners {
  std::array<glm::dvec3, 3> at;
};

// A sum of half solid angles, kept as a complex number and whole turns: one arc tangent for all.
class AngleSum {
 public:
  // Of a triangle seen from q (Van Oosterom & Strackee 1983, eq. 8).
  void add(const Corners& triangle, const glm::dvec3& q) {
    const auto a = triangle.at[0] - q, b = triangle.at[1] - q, c = triangle.at[2] - q;
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    const double volume = glm::dot(a, glm::cross(b, c)), lengths = la * lb * lc;
    const double scale = lengths + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
    if (lengths > 0) turnBy(scale / lengths, volume / lengths);
  }

  double total() const { return turns_ * 2 * std::numbers::pi + std::atan2(imaginary_, real_); }

 private:
  void turnBy(double real, double imaginary) {
    const double product = real_ * real - imaginary_ * imaginary;
    const double next = real_ * imaginary + imaginary_ * real;
    // Two angles of one sign whose sum has the other have passed half a turn.
    if (imaginary_ > 0 && imaginary > 0 && next < 0) ++turns_;
    if (imaginary_ < 0 && imaginary < 0 && next >= 0) --turns_;
    const double size = std::abs(product) + std::abs(next);
    if (!(size > 0)) return;
    real_ = product / size;
    imaginary_ = next / size;
  }

  double real_ = 1, imaginary_ = 0;
  int turns_ = 0;
};

}  // namespace

struct WindingTree::Tree {
  std::vector<Cluster> nodes;
  std::vector<Corners> triangles;
  std::vector<glm::dvec3> centroids;

  void build(std::size_t first, std::size_t last) {
    const std::size_t node = nodes.size();
    nodes.emplace_back();
    nodes[node].first = static_cast<std::uint32_t>(first);
    nodes[node].count = static_cast<std::uint32_t>(last - first);
    summarise(nodes[node]);
    if (last - first <= kLeafTriangles) return;
    split(first, last);
    const std::size_t middle = first + (last - first) / 2;
    nodes[node].count = 0;
    build(first, middle);
    nodes[node].right = static_cast<std::uint32_t>(nodes.size());
    build(middle, last);
  }

  // Halves the range by centroid along the longest side.
  void split(std::size_t first, std::size_t last) {
    glm::dvec3 low = centroids[first], high = low;
    for (std::size_t n = first; n < last; ++n) {
      low = glm::min(low, centroids[n]);
      high = glm::max(high, centroids[n]);
    }
    const auto size = high - low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    std::vector<std::uint32_t> order(last - first);
    std::iota(order.begin(), order.end(), static_cast<std::uint32_t>(first));
    std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(order.size() / 2),
                     order.end(), [&](auto a, auto b) {
                       const double x = centroids[a][axis], y = centroids[b][axis];
                       return x != y ? x < y : a < b;
                     });
    permute(order, first);
  }

  void permute(const std::vector<std::uint32_t>& order, std::size_t first) {
    std::vector<Corners> corners;
    std::vector<glm::dvec3> middles;
    corners.reserve(order.size());
    middles.reserve(order.size());
    for (const auto n : order) {
      corners.push_back(triangles[n]);
      middles.push_back(centroids[n]);
    }
    const auto offset = static_cast<std::ptrdiff_t>(first);
    std::copy(corners.begin(), corners.end(), triangles.begin() + offset);
    std::copy(middles.begin(), middles.end(), centroids.begin() + offset);
  }

  void summarise(Cluster& cluster) const {
    const std::size_t first = cluster.first, last = first + cluster.count;
    double area = 0;
    glm::dvec3 weighted(0), plain(0);
    for (std::size_t n = first; n < last; ++n) {
      const double part = glm::length(areaNormal(n));
      area += part;
      weighted += part * centroids[n];
      plain += centroids[n];
    }
    cluster.middle = area > 0 ? weighted / area : plain / double(cluster.count);
    double squared = 0;
    for (std::size_t n = first; n < last; ++n) {
      const auto centroid = centroids[n] - cluster.middle;
      glm::dmat3 second = 9.0 * glm::outerProduct(centroid, centroid);
      for (const auto& p : triangles[n].at) {
        const auto r = p - cluster.middle;
        second += glm::outerProduct(r, r);
        squared = std::max(squared, glm::dot(r, r));
      }
      cluster.add(areaNormal(n), centroid, second / 12.0);
    }
    cluster.farSquared = kFar * kFar * squared;
  }

  glm::dvec3 areaNormal(std::size_t n) const {
    const auto& at = triangles[n].at;
    return 0.5 * glm::cross(at[1] - at[0], at[2] - at[0]);
  }
};

WindingTree::WindingTree(const TriangleMesh& mesh) {
  auto tree = std::make_unique<Tree>();
  for (const auto& t : mesh.triangles) {
    const auto &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    tree->triangles.push_back({{a, b, c}});
    tree->centroids.push_back((a + b + c) / 3.0);
  }
  if (!mesh.triangles.empty()) tree->build(0, mesh.triangles.size());
  tree_ = std::move(tree);
}

WindingTree::~WindingTree() = default;

double WindingTree::at(const glm::dvec3& point) const {
  if (tree_->nodes.empty()) return 0;
  double far = 0;
  AngleSum near;
  std::array<std::uint32_t, 64> open;  // halving 2³² triangles takes 32 levels
  std::size_t depth = 0;
  open[depth++] = 0;
  while (depth > 0) {
    const std::uint32_t number = open[--depth];
    const Cluster& node = tree_->nodes[number];
    const auto r = node.middle - point;
    const double squared = glm::dot(r, r);
    if (squared > node.farSquared) {
      far += node.windingFrom(r, squared);
      continue;
    }
    for (std::uint32_t n = 0; n < node.count; ++n) {
      near.add(tree_->triangles[node.first + n], point);
    }
    if (node.count > 0) continue;
    open[depth++] = node.right;
    open[depth++] = number + 1;
  }
  return (far + 2 * near.total()) / kSolidAngle;
}

}  // namespace bozzetto
