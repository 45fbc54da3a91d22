// What a stroke asks for that plays no part where clay is moved.
#pragma once
#include <string>

#include "bozzetto/clay/stroke.hpp"

namespace bozzetto::clay {

/// One line that names it, for whoever made the stroke; empty when all of it counts.
std::string idleIn(const Stroke& stroke, Role role, const Settings& settings);

/// The stroke without what it names in vain: where clay is moved it does the same.
Stroke withoutIdle(Stroke stroke);

}  // namespace bozzetto::clay
