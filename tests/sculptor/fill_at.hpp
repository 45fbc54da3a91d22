// A small change that is easily told from others.
#pragma once
#include "bozzetto/sculptor/operation.hpp"

namespace bozzetto::testing {

inline FillOperation fillAt(double x) {
  FillOperation fill;
  fill.primitive.centre = {x, 0, 0};
  return fill;
}

}  // namespace bozzetto::testing
