// What two boxes of keys make together.
#pragma once
#include "bozzetto/grid/key.hpp"

namespace bozzetto {

/// The smallest box that holds both; an empty one counts for nothing.
KeyBox united(const KeyBox& a, const KeyBox& b);

/// The corners of both; empty where they do not meet.
KeyBox common(const KeyBox& a, const KeyBox& b);

}  // namespace bozzetto
