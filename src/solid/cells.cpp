#include "bozzetto/solid/cells.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

namespace bozzetto {
namespace {

constexpr double kRim = 1e-9;  // places this far beyond a face still belong

// Derivatives along u, v, w.
std::array<glm::dvec3, 3> jacobian(const CellPiece& hex, const glm::dvec3& p) {
  std::array<glm::dvec3, 3> result{glm::dvec3(0), glm::dvec3(0), glm::dvec3(0)};
  for (std::size_t n = 0; n < 8; ++n) {
    const glm::dvec3 up(n & 1, n >> 1 & 1, n >> 2);
    const glm::dvec3 weight = up * p + (1.0 - up) * (1.0 - p), sign = 2.0 * up - 1.0;
    result[0] += sign.x * weight.y * weight.z * hex.corner[n];
    result[1] += weight.x * sign.y * weight.z * hex.corner[n];
    result[2] += weight.x * weight.y * sign.z * hex.corner[n];
  }
  return result;
}

double scaleSquared(const CellPiece& hex) {
  double most = 0;
  for (const auto& p : hex.corner)
    most = std::max(most, glm::dot(p - hex.corner[0], p - hex.corner[0]));
  return most;
}

// x with j x = miss, by Cramer's rule.
glm::dvec3 solved(const std::array<glm::dvec3, 3>& j, const glm::dvec3& miss, double det) {
  return glm::dvec3(glm::dot(glm::cross(j[1], j[2]), miss), glm::dot(glm::cross(j[2], j[0]), miss),
                    glm::dot(glm::cross(j[0], j[1]), miss)) /
         det;
}

std::optional<glm::dvec3> inTetrahedron(const CellPiece& piece, const glm::dvec3& place) {
  std::array<glm::dvec3, 3> arms;
  for (std::size_t n = 0; n < 3; ++n) arms[n] = piece.corner[n + 1] - piece.corner[0];
  const double det = glm::dot(glm::cross(arms[0], arms[1]), arms[2]);
  if (det == 0) return std::nullopt;
  const glm::dvec3 uvw = solved(arms, place - piece.corner[0], det);
  const bool inside =
      uvw.x >= -kRim && uvw.y >= -kRim && uvw.z >= -kRim && uvw.x + uvw.y + uvw.z <= 1 + kRim;
  return inside ? std::optional(uvw) : std::nullopt;
}

class Cutter {
 public:
  explicit Cutter(const Lattice& lattice) : lattice_(lattice), topology_(lattice) {}

  CellPieces run() {
    for (Id cell = 0; cell < lattice_.cells.size(); ++cell)
      if (!addHexahedron(cell)) addTetrahedra(cell);
    return std::move(result_);
  }

 private:
  std::vector<Id> neighboursIn(Id cell, Id point) const {
    std::vector<Id> result;
    for (const Id edge : topology_.cellEdges[cell]) {
      const PointPair& ends = topology_.edges[edge];
      if (ends[0] == point || ends[1] == point) result.push_back(topology_.otherEnd(edge, point));
    }
    return result;
  }

  bool isHexahedron(Id cell) const {
    if (lattice_.cells[cell].size() != 6 || topology_.cellPoints[cell].size() != 8) return false;
    for (const Id face : lattice_.cells[cell])
      if (lattice_.faces[face].size() != 4) return false;
    for (const Id point : topology_.cellPoints[cell])
      if (neighboursIn(cell, point).size() != 3) return false;
    return true;
  }

  // The corner of a quad across from `origin`, when it also holds a and b.
  Id across(Id cell, Id origin, Id a, Id b) const {
    for (const Id face : lattice_.cells[cell]) {
      const auto loop = lattice_.faces[face];
      const auto has = [&](Id n) { return std::ranges::find(loop, n) != loop.end(); };
      if (!has(origin) || !has(a) || !has(b)) continue;
      for (const Id n : loop)
        if (n != origin && n != a && n != b) return n;
    }
    return kNoId;
  }

  bool addHexahedron(Id cell) {
    if (!isHexahedron(cell)) return false;
    const auto points = topology_.cellPoints[cell];
    const Id origin = points[0];
    auto near = neighboursIn(cell, origin);
    const auto arm = [&](std::size_t n) {
      return lattice_.points[near[n]] - lattice_.points[origin];
    };
    if (glm::dot(glm::cross(arm(0), arm(1)), arm(2)) < 0) std::swap(near[0], near[1]);
    CellPieces::Piece piece{
        PieceKind::hexahedron,
        {origin, near[0], near[1], across(cell, origin, near[0], near[1]), near[2],
         across(cell, origin, near[0], near[2]), across(cell, origin, near[1], near[2]), kNoId},
        cell};
    for (const Id point : points) {
      if (std::ranges::find(piece.points, point) == piece.points.end()) piece.points[7] = point;
    }
    if (std::ranges::find(piece.points, kNoId) != piece.points.end()) return false;
    result_.pieces.push_back(piece);
    return true;
  }

  Id addMiddle(std::span<const Id> points) {
    result_.middles.emplace_back(points.begin(), points.end());
    return static_cast<Id>(lattice_.points.size() + result_.middles.size() - 1);
  }

  void addTetrahedra(Id cell) {
    const Id top = addMiddle(topology_.cellPoints[cell]);
    const glm::dvec3 topPlace = meanOf(lattice_, topology_.cellPoints[cell]);
    for (const Id face : lattice_.cells[cell]) {
      const auto loop = lattice_.faces[face];
      const auto [known, added] = faceMiddles_.try_emplace(face, kNoId);
      if (added) known->second = addMiddle(loop);
      const glm::dvec3 middle = meanOf(lattice_, loop);
      for (std::size_t n = 0; n < loop.size(); ++n) {
        Id a = loop[n], b = loop[(n + 1) % loop.size()];
        const glm::dvec3 toA = lattice_.points[a] - middle, toB = lattice_.points[b] - middle;
        if (glm::dot(glm::cross(toA, toB), topPlace - middle) < 0) std::swap(a, b);
        const Id m = known->second;
        result_.pieces.push_back(
            {PieceKind::tetrahedron, {m, a, b, top, top, top, top, top}, cell});
      }
    }
  }

  const Lattice& lattice_;
  Topology topology_;
  CellPieces result_;
  std::map<Id, Id> faceMiddles_;
};

}  // namespace

glm::dvec3 CellPiece::at(const glm::dvec3& p) const {
  if (kind == PieceKind::tetrahedron) {
    return (1 - p.x - p.y - p.z) * corner[0] + p.x * corner[1] + p.y * corner[2] + p.z * corner[3];
  }
  const auto mix = [](const glm::dvec3& a, const glm::dvec3& b, double t) {
    return (1 - t) * a + t * b;
  };
  const glm::dvec3 low = mix(mix(corner[0], corner[1], p.x), mix(corner[2], corner[3], p.x), p.y);
  const glm::dvec3 high = mix(mix(corner[4], corner[5], p.x), mix(corner[6], corner[7], p.x), p.y);
  return mix(low, high, p.z);
}

std::optional<glm::dvec3> CellPiece::inverse(const glm::dvec3& place,
                                             const glm::dvec3& start) const {
  if (kind == PieceKind::tetrahedron) return inTetrahedron(*this, place);
  constexpr int kMostSteps = 12;
  const double scale = scaleSquared(*this);
  glm::dvec3 uvw = start;
  for (int step = 0; step < kMostSteps; ++step) {
    const glm::dvec3 miss = at(uvw) - place;
    if (glm::dot(miss, miss) < 1e-18 * scale) break;
    if (step == kMostSteps - 1) return std::nullopt;
    const auto j = jacobian(*this, uvw);
    const double det = glm::dot(glm::cross(j[0], j[1]), j[2]);
    if (!(std::abs(det) > 1e-14 * scale * std::sqrt(scale))) return std::nullopt;
    uvw -= solved(j, miss, det);
    for (int axis = 0; axis < 3; ++axis)
      if (!(uvw[axis] >= -2 && uvw[axis] <= 3)) return std::nullopt;
  }
  for (int axis = 0; axis < 3; ++axis)
    if (uvw[axis] < -kRim || uvw[axis] > 1 + kRim) return std::nullopt;
  return uvw;
}

std::array<glm::dvec3, 3> CellPiece::derivatives(const glm::dvec3& uvw) const {
  if (kind == PieceKind::hexahedron) return jacobian(*this, uvw);
  return {corner[1] - corner[0], corner[2] - corner[0], corner[3] - corner[0]};
}

double CellPiece::volume() const {
  if (kind == PieceKind::tetrahedron) {
    const auto arm = [&](std::size_t n) { return corner[n] - corner[0]; };
    return glm::dot(glm::cross(arm(1), arm(2)), arm(3)) / 6;
  }
  const double g = 0.5 / std::sqrt(3.0);
  double sum = 0;
  for (std::size_t n = 0; n < 8; ++n) {
    const glm::dvec3 p(n & 1 ? 0.5 + g : 0.5 - g, n & 2 ? 0.5 + g : 0.5 - g,
                       n & 4 ? 0.5 + g : 0.5 - g);
    const auto j = jacobian(*this, p);
    sum += glm::dot(glm::cross(j[0], j[1]), j[2]) / 8;
  }
  return sum;
}

CellPiece CellPieces::at(std::size_t n, std::span<const glm::dvec3> places) const {
  CellPiece result{pieces[n].kind, {}};
  for (std::size_t k = 0; k < 8; ++k) result.corner[k] = places[pieces[n].points[k]];
  return result;
}

std::vector<glm::dvec3> CellPieces::places(std::span<const glm::dvec3> points) const {
  std::vector<glm::dvec3> result(points.begin(), points.end());
  for (const auto& list : middles) {
    glm::dvec3 sum{0};
    for (const Id n : list) sum += points[n];
    result.push_back(sum / static_cast<double>(list.size()));
  }
  return result;
}

CellPieces piecesOf(const Lattice& refined) { return Cutter(refined).run(); }

}  // namespace bozzetto
