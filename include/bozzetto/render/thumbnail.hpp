// The small picture that a scene carries, for dialogs that let somebody choose one.
#pragma once
#include "bozzetto/base/bytes.hpp"
#include "bozzetto/field/field.hpp"

namespace bozzetto {

/// A PNG; empty where there is no clay or no OpenGL off-screen. Large clay is
/// shown by a coarser copy of it. Makes its own context: none is current afterwards.
Bytes thumbnailOf(const Clay& clay, int width = 256, int height = 256);

}  // namespace bozzetto
