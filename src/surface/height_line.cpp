#include "surface/height_line.hpp"

#include <bit>
#include <memory>

namespace bozzetto {

RayLine::RayLine(FieldSampler<8>& sampler, const RayFrame& frame, FinePlace place)
    : sampler_(&sampler), frame_(&frame), u_(frame.u()), v_(frame.v()), axis_(frame.axis()) {
  for (int n = 0; n < 4; ++n)
    rows_[std::size_t(n)] = frame.key((place[0] >> 2) + n / 2, (place[1] >> 2) + n % 2, 0);
  const float u = float(place[0] & (kFine - 1)) / kFine, v = float(place[1] & (kFine - 1)) / kFine;
  weights_ = {(1 - u) * (1 - v), (1 - u) * v, u * (1 - v), u * v};
}

Key RayLine::key(std::int32_t depth, int n, int du, int dv) const {
  Key key = rows_[std::size_t(n)];
  key[axis_] = frame_->turned(depth);
  key[u_] += du;
  key[v_] += dv;
  return key;
}

float RayLine::at(std::int32_t depth, int du, int dv) const {
  if (weights_[0] == 1) return sampler_->corner(key(depth, 0, du, dv));
  float sum = 0;
  for (int n = 0; n < 4; ++n) {
    const float weight = weights_[std::size_t(n)];
    if (weight > 0) sum += weight * sampler_->corner(key(depth, n, du, dv));
  }
  return sum;
}

Attributes RayLine::attributes(std::int32_t depth) const {
  float most = 0;
  Attributes found = 0;
  for (int n = 0; n < 4; ++n) {
    const float weight = weights_[std::size_t(n)];
    const Key corner = key(depth, n, 0, 0);
    if (weight <= most || !(sampler_->corner(corner) > 0)) continue;
    most = weight;
    found = sampler_->attributes(corner);
  }
  return found;
}

// The edge's smaller corner on the axis comes first: A.
void RayLine::gather(std::int32_t depth, CrossingEdges& edges, int n) const {
  const int up = frame_->fromAbove() ? -1 : 1;  // depth of the next greater coordinate
  const std::int32_t a = frame_->fromAbove() ? depth : depth - 1, b = a + up;
  const auto u = std::size_t(index(frame_->u())), v = std::size_t(index(frame_->v()));
  const auto axis = std::size_t(index(frame_->axis())), m = std::size_t(n);
  edges.valueA[m] = edges.belowB[axis][m] = at(a);
  edges.valueB[m] = edges.aboveA[axis][m] = at(b);
  edges.belowA[axis][m] = at(a - up);
  edges.aboveB[axis][m] = at(b + up);
  edges.belowA[u][m] = at(a, -1, 0);
  edges.aboveA[u][m] = at(a, 1, 0);
  edges.belowB[u][m] = at(b, -1, 0);
  edges.aboveB[u][m] = at(b, 1, 0);
  edges.belowA[v][m] = at(a, 0, -1);
  edges.aboveA[v][m] = at(a, 0, 1);
  edges.belowB[v][m] = at(b, 0, -1);
  edges.aboveB[v][m] = at(b, 0, 1);
  edges.coloursA[m] = attributes(a);
  edges.coloursB[m] = attributes(b);
  edges.place[m] = CrossingEdges::placeOf(0, 0, 0, index(frame_->axis()));
}

LineVertex lineVertex(const CrossingEdges& edges, int n, const RayFrame& frame) {
  const auto m = std::size_t(n);
  const float t = edges.position[std::size_t(index(frame.axis()))][m];
  LineVertex found;
  found.back = frame.fromAbove() ? t : 1 - t;
  found.vertex.normal = std::bit_cast<std::array<std::int16_t, 2>>(edges.normal[m]);
  found.vertex.colour = std::bit_cast<std::array<std::uint8_t, 4>>(edges.colour[m]);
  return found;
}

CrossingEdges& edgeScratch() {
  thread_local const auto edges = std::make_unique<CrossingEdges>();
  return *edges;
}

}  // namespace bozzetto
