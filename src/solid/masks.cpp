#include "solid/masks.hpp"

#include <algorithm>

namespace bozzetto {
namespace {

std::vector<Id> onBoundary(std::span<const Id> list, const std::vector<std::uint8_t>& boundary) {
  std::vector<Id> result;
  for (const Id n : list)
    if (boundary[n] != 0) result.push_back(n);
  return result;
}

}  // namespace

bool hasOneFan(const Topology& topology, Id point) {
  const auto faces = onBoundary(topology.pointFaces[point], topology.boundaryFace);
  const auto edges = onBoundary(topology.pointEdges[point], topology.boundaryEdge);
  if (faces.size() != edges.size() || faces.empty()) return false;

  // From face to face over the edges at the point, each of which must have two of them.
  std::vector<Id> fan{faces[0]};
  for (std::size_t done = 0; done < fan.size(); ++done) {
    for (const Id edge : topology.faceEdges[fan[done]]) {
      const PointPair& ends = topology.edges[edge];
      if (ends[0] != point && ends[1] != point) continue;
      const auto beside = onBoundary(topology.edgeFaces[edge], topology.boundaryFace);
      if (beside.size() != 2) return false;
      for (const Id face : beside)
        if (std::ranges::find(fan, face) == fan.end()) fan.push_back(face);
    }
  }
  return fan.size() == faces.size();
}

WeightRows Masks::rows() {
  result_.columnCount = lattice_.points.size();
  for (Id n = 0; n < lattice_.points.size(); ++n) vertexRow(n), endRow();
  for (Id n = 0; n < topology_.edges.size(); ++n) edgeRow(n), endRow();
  for (Id n = 0; n < lattice_.faces.size(); ++n) faceRow(n), endRow();
  for (Id n = 0; n < lattice_.cells.size(); ++n) cell(n, 1), endRow();
  return std::move(result_);
}

void Masks::point(Id n, double w) {
  touched_.push_back(n);
  sum_[n] += w;
}

void Masks::mean(std::span<const Id> points, double w) {
  for (const Id n : points) point(n, w / static_cast<double>(points.size()));
}

void Masks::face(Id n, double w) { mean(lattice_.faces[n], w); }
void Masks::cell(Id n, double w) { mean(topology_.cellPoints[n], w); }
void Masks::middle(Id edge, double w) { mean(topology_.edges[edge], w); }

void Masks::endRow() {
  constexpr double kNothing = 1e-15;
  std::ranges::sort(touched_);
  touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
  for (const Id n : touched_) {
    if (sum_[n] > kNothing || sum_[n] < -kNothing) {
      result_.columns.push_back(n);
      result_.weights.push_back(sum_[n]);
    }
    sum_[n] = 0;
  }
  touched_.clear();
  result_.start.push_back(static_cast<Id>(result_.columns.size()));
}

// (C0 + 2A + C1)/4 inside, A on the boundary.
void Masks::faceRow(Id n) {
  if (topology_.boundaryFace[n] != 0) return face(n, 1);
  for (const Id c : topology_.faceCells[n]) cell(c, 0.25);
  face(n, 0.5);
}

// (C + 2A + (n−3)M)/n inside, C and A plain means of old centroids.
void Masks::edgeRow(Id edge) {
  if (topology_.boundaryEdge[edge] != 0) return boundaryEdge(edge);
  const auto faces = topology_.edgeFaces[edge], cells = topology_.edgeCells[edge];
  const double n = static_cast<double>(faces.size());
  for (const Id c : cells) cell(c, 1 / (n * static_cast<double>(cells.size())));
  for (const Id f : faces) face(f, 2 / (n * n));
  middle(edge, (n - 3) / n);
}

// (2M + A0 + A1)/4; the midpoint where sharp or not manifold.
void Masks::boundaryEdge(Id edge) {
  const auto faces = onBoundary(topology_.edgeFaces[edge], topology_.boundaryFace);
  if (faces.size() != 2 || isSharp(edge)) return middle(edge, 1);
  middle(edge, 0.5);
  for (const Id f : faces) face(f, 0.25);
}

// (C + 3A + 3M + V)/8 inside.
void Masks::vertexRow(Id n) {
  if (topology_.boundaryPoint[n] != 0) return boundaryVertex(n);
  const auto cells = topology_.pointCells[n], faces = topology_.pointFaces[n],
             edges = topology_.pointEdges[n];
  if (cells.empty()) return point(n, 1);  // nobody's point stays
  for (const Id c : cells) cell(c, 0.125 / static_cast<double>(cells.size()));
  for (const Id f : faces) face(f, 0.375 / static_cast<double>(faces.size()));
  for (const Id e : edges) middle(e, 0.375 / static_cast<double>(edges.size()));
  point(n, 0.125);
}

// (A + 2M + (n−3)V)/n over boundary faces; crease, corner and non-manifold rules of solid.md §1.
void Masks::boundaryVertex(Id v) {
  const auto faces = onBoundary(topology_.pointFaces[v], topology_.boundaryFace);
  const auto edges = onBoundary(topology_.pointEdges[v], topology_.boundaryEdge);
  std::vector<Id> creases;
  for (const Id edge : edges)
    if (isSharp(edge)) creases.push_back(edge);
  const bool tagged = std::ranges::binary_search(lattice_.sharpPoints, v);
  if (tagged || creases.size() >= 3 || !hasOneFan(topology_, v)) return point(v, 1);
  if (creases.size() == 2) {
    point(v, 0.5);
    for (const Id edge : creases) middle(edge, 0.25);
    return;
  }
  const double n = static_cast<double>(faces.size());
  for (const Id f : faces) face(f, 1 / (n * n));
  for (const Id e : edges) middle(e, 2 / (n * n));
  point(v, (n - 3) / n);
}

bool Masks::isSharp(Id edge) const {
  return std::ranges::binary_search(lattice_.sharpEdges, topology_.edges[edge]);
}

}  // namespace bozzetto
