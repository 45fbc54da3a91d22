// What two boxes of keys make together.
#pragma once
#include "bozzetto/grid/key.hpp"

namespace bozzetto {

/// The smallest box that holds both; an empty one counts for nothing.
KeyBox united(const KeyBox& a, const KeyBox& b);

/// The corners of both; empty where they do not meet.
KeyBox common(const KeyBox& a, const KeyBox& b);

/// callback(key) for all keys of the box, in their order.
template <class Callback>
void forKeys(const KeyBox& box, Callback&& callback) {
  for (std::int32_t i = box.low.i; i <= box.high.i; ++i)
    for (std::int32_t j = box.low.j; j <= box.high.j; ++j)
      for (std::int32_t k = box.low.k; k <= box.high.k; ++k) callback(Key{i, j, k});
}

}  // namespace bozzetto
