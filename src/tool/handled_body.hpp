// The body of a stamp's tool with its handle: what rose in the way of the handle goes again.
#pragma once
#include <algorithm>

#include "tool/stamp_depth.hpp"
#include "tool/swept.hpp"

namespace bozzetto {

/// Adds to `body` the room of the handle, as far as there was no clay before the stroke: presses
/// end at what was there, so a tool may go deep below the surface and leave it whole.
template <int Side>
void addHandle(const StampTool& tool, const LocalFrame& frame, Key first,
               const CornerBlock<Side>* before, float* body) {
  constexpr int count = CornerBlock<Side>::kCount;
  alignas(64) float room[count];
  tool.evaluateHandle(frame, first, Side, room);
  for (int n = 0; n < count; ++n) {
    const float clay = before == nullptr ? 0 : before->value[static_cast<std::size_t>(n)];
    body[n] = std::max(body[n], std::min(room[n], 1 - std::min(clay, 1.0f)));
  }
}

}  // namespace bozzetto
