#include "bozzetto/grid/key_box.hpp"

#include <algorithm>

namespace bozzetto {

KeyBox united(const KeyBox& a, const KeyBox& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  KeyBox result;
  for (const Axis axis : kAxes) {
    result.low[axis] = std::min(a.low[axis], b.low[axis]);
    result.high[axis] = std::max(a.high[axis], b.high[axis]);
  }
  return result;
}

KeyBox common(const KeyBox& a, const KeyBox& b) {
  KeyBox result;
  for (const Axis axis : kAxes) {
    result.low[axis] = std::max(a.low[axis], b.low[axis]);
    result.high[axis] = std::min(a.high[axis], b.high[axis]);
  }
  return result;
}

}  // namespace bozzetto
