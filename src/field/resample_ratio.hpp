#pragma once
#include "bozzetto/field/field.hpp"

namespace bozzetto {

/// Old cells per new cell. Throws Error for a spacing that is not a sane number and for clay that
/// would leave the workspace.
double resampleRatio(const Clay& field, double spacing);

}  // namespace bozzetto
