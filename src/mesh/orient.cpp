#include "bozzetto/mesh/orient.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "bozzetto/mesh/check.hpp"
#include "bozzetto/mesh/winding.hpp"
#include "mesh/edge_table.hpp"

namespace bozzetto {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// Across side n of triangle t, at 3·t + n: the neighbour, and whether both walk the edge the same
// way and so disagree. Only edges of exactly two triangles connect.
struct Neighbour {
  std::uint32_t triangle = kNone;
  bool disagrees = false;
};

std::vector<Neighbour> neighboursOf(const TriangleMesh& mesh) {
  std::vector<Neighbour> neighbours(3 * mesh.triangles.size());
  forEachEdge(mesh, [&](std::uint32_t, std::span<const TriangleSide> sides) {
    if (sides.size() != 2) return;
    const bool disagrees = sides[0].rising == sides[1].rising;
    neighbours[sides[0].corner] = {sides[1].corner / 3, disagrees};
    neighbours[sides[1].corner] = {sides[0].corner / 3, disagrees};
  });
  return neighbours;
}

using Part = std::vector<std::uint32_t>;

void turn(TriangleMesh& mesh, std::uint32_t triangle) {
  std::swap(mesh.triangles[triangle][1], mesh.triangles[triangle][2]);
}

class Orienter {
 public:
  explicit Orienter(TriangleMesh& mesh) : mesh_(mesh), turned_(mesh.triangles.size(), 0) {}

  std::size_t run() {
    makePartsAgree();
    const auto middle = middleOf(mesh_.triangles.size(), [](std::size_t n) { return n; });
    if (volumeAbout(middle, allTriangles()) < 0) turnAll(allTriangles());
    turnInwardParts();
    return static_cast<std::size_t>(std::count(turned_.begin(), turned_.end(), 1));
  }

 private:
  void makePartsAgree() {
    const auto neighbours = neighboursOf(mesh_);
    std::vector<std::uint8_t> seen(mesh_.triangles.size(), 0);
    for (std::uint32_t start = 0; start < seen.size(); ++start) {
      if (seen[start] != 0) continue;
      parts_.push_back(spread(start, neighbours, seen));
    }
  }

  // Walks one part; marks in turned_ what disagrees with `start`, or the rest if that is less.
  Part spread(std::uint32_t start, const std::vector<Neighbour>& neighbours,
              std::vector<std::uint8_t>& seen) {
    Part part{start};
    seen[start] = 1;
    std::size_t against = 0;
    for (std::size_t done = 0; done < part.size(); ++done) {
      const auto t = part[done];
      for (std::size_t n = 3 * std::size_t{t}; n < 3 * std::size_t{t} + 3; ++n) {
        const auto& next = neighbours[n];
        if (next.triangle == kNone || seen[next.triangle] != 0) continue;
        seen[next.triangle] = 1;
        turned_[next.triangle] = turned_[t] ^ static_cast<std::uint8_t>(next.disagrees);
        against += turned_[next.triangle];
        part.push_back(next.triangle);
      }
    }
    const std::uint8_t minority = 2 * against > part.size() ? 0 : 1;
    for (const auto t : part) {
      turned_[t] = turned_[t] == minority ? 1 : 0;
      if (turned_[t] != 0) turn(mesh_, t);
    }
    return part;
  }

  void turnAll(const Part& part) {
    for (const auto t : part) {
      turn(mesh_, t);
      turned_[t] ^= 1;
    }
  }

  // An inward part is a mistake unless what surrounds it is clay.
  void turnInwardParts() {
    std::vector<const Part*> inward;
    for (const auto& part : parts_) {
      const auto middle = middleOf(part.size(), [&](std::size_t n) { return part[n]; });
      if (part.size() > 3 && volumeAbout(middle, part) < 0) inward.push_back(&part);
    }
    if (inward.empty()) return;
    const WindingTree winding(mesh_);
    std::erase_if(inward, [&](const Part* part) { return !isMistake(*part, winding); });
    for (const Part* part : inward) turnAll(*part);
  }

  // Front and back of the part's largest triangle: -1 and 0 for an inward body alone, 0 and 1 for
  // a cavity.
  bool isMistake(const Part& part, const WindingTree& winding) const {
    const auto largest = *std::max_element(part.begin(), part.end(), [&](auto a, auto b) {
      return glm::length(areaNormal(a)) < glm::length(areaNormal(b));
    });
    const auto& t = mesh_.triangles[largest];
    const auto centroid =
        (mesh_.positions[t[0]] + mesh_.positions[t[1]] + mesh_.positions[t[2]]) / 3.0;
    const auto normal = areaNormal(largest);
    const double size = std::sqrt(glm::length(normal));
    if (!(size > 0)) return false;
    const auto step = normal / size * 1e-3;
    return winding.at(centroid + step) + winding.at(centroid - step) < -0.5;
  }

  glm::dvec3 areaNormal(std::uint32_t n) const {
    const auto& t = mesh_.triangles[n];
    const auto a = mesh_.positions[t[0]];
    return glm::cross(mesh_.positions[t[1]] - a, mesh_.positions[t[2]] - a);
  }

  Part allTriangles() const {
    Part all(mesh_.triangles.size());
    for (std::uint32_t n = 0; n < all.size(); ++n) all[n] = n;
    return all;
  }

  // The middle of the box of `count` triangles.
  template <class Numbering>
  glm::dvec3 middleOf(std::size_t count, Numbering number) const {
    MeshBounds bounds;
    for (std::size_t n = 0; n < count; ++n) {
      for (const auto v : mesh_.triangles[number(n)]) bounds.add(mesh_.positions[v]);
    }
    return bounds.min + 0.5 * bounds.size();
  }

  double volumeAbout(const glm::dvec3& middle, const Part& part) const {
    double sum = 0;
    for (const auto n : part) {
      const auto& t = mesh_.triangles[n];
      const auto a = mesh_.positions[t[0]] - middle, b = mesh_.positions[t[1]] - middle;
      sum += glm::dot(a, glm::cross(b, mesh_.positions[t[2]] - middle));
    }
    return sum;
  }

  TriangleMesh& mesh_;
  std::vector<std::uint8_t> turned_;
  std::vector<Part> parts_;
};

}  // namespace

std::size_t orientOutward(TriangleMesh& mesh) { return Orienter(mesh).run(); }

}  // namespace bozzetto
