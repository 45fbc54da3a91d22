// One ray: density along it, between four rows of corners, and the vertices where it meets clay.
#pragma once
#include "surface/height_rays.hpp"
#include "surface/vertex_kernel.hpp"

namespace bozzetto {

inline constexpr int kFine = 4;  // rays along a cell's side where depth jumps

/// Quarters of a cell along u and v.
using FinePlace = std::array<std::int32_t, 2>;

class RayLine {
 public:
  RayLine(FieldSampler<8>& sampler, const RayFrame& frame, FinePlace place);

  float at(std::int32_t depth, int du = 0, int dv = 0) const;
  /// Of the nearest corner with clay.
  Attributes attributes(std::int32_t depth) const;
  /// What a vertex between `depth` and the corner before it needs, as the n-th of `edges`.
  void gather(std::int32_t depth, CrossingEdges& edges, int n) const;

 private:
  Key key(std::int32_t depth, int n, int du, int dv) const;

  FieldSampler<8>* sampler_;
  const RayFrame* frame_;
  Axis u_, v_, axis_;
  std::array<Key, 4> rows_;
  std::array<float, 4> weights_;
};

/// A vertex whose position is not known, and how far before its corner inside it lies.
struct LineVertex {
  PatchVertex vertex{};
  float back = 0;
};
LineVertex lineVertex(const CrossingEdges& edges, int n, const RayFrame& frame);

/// For one thread.
CrossingEdges& edgeScratch();

}  // namespace bozzetto
