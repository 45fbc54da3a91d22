// Moves matter by its displacement at faces, exactly conserving, colours with it.
#pragma once
#include "clay/layer.hpp"

namespace bozzetto::clay {

/// Moves by region.face, axis by axis, in turning order from step to step. Faces between closed
/// cells have displacement 0; more than 0.9 cells count as 0.9.
void transport(Work& work);

}  // namespace bozzetto::clay
