// The small picture that a scene carries, for dialogs that let somebody choose one.
#pragma once
#include "bozzetto/base/bytes.hpp"
#include "bozzetto/field/field.hpp"

namespace bozzetto {

/// A PNG of 256 × 256 pixels; empty where there is no clay or no OpenGL off-screen. Large clay is
/// shown by a coarser copy of it. Makes its own context: none is current afterwards.
Bytes thumbnailOf(const Clay& clay);

}  // namespace bozzetto
