// The weights of one refinement (algorithms §5, solid.md §1), row by row.
#pragma once
#include "bozzetto/solid/refine.hpp"

namespace bozzetto {

class Masks {
 public:
  Masks(const Lattice& lattice, const Topology& topology)
      : lattice_(lattice), topology_(topology), sum_(lattice.points.size(), 0) {}

  /// Vertex points, edge points, face points, cell points.
  WeightRows rows();

 private:
  // Parts of a row, each times w: a point, the mean of a face, of a cell, of an edge's ends.
  void point(Id n, double w);
  void face(Id n, double w);
  void cell(Id n, double w);
  void middle(Id edge, double w);
  void mean(std::span<const Id> points, double w);
  void endRow();

  void vertexRow(Id n);
  void edgeRow(Id n);
  void faceRow(Id n);
  void boundaryVertex(Id n);
  void boundaryEdge(Id n);
  bool isSharp(Id edge) const;

  const Lattice& lattice_;
  const Topology& topology_;
  std::vector<double> sum_;
  std::vector<Id> touched_;
  WeightRows result_;
};

/// The boundary faces round a boundary point form one closed fan.
bool hasOneFan(const Topology& topology, Id point);

}  // namespace bozzetto
