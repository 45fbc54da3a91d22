// What can be said of where a tool comes from before anything is read.
#include <fmt/format.h>

#include <cmath>

#include "bozzetto/base/error.hpp"
#include "bozzetto/sculptor/tool_operations.hpp"
#include "bozzetto/tool/relative.hpp"

namespace bozzetto {
namespace {

void requireIn(double number, double low, double high, const char* what) {
  if (number >= low && number <= high) return;
  throw Error(fmt::format("tool {}: {:g} found, a number in {:g} to {:g} expected", what, number,
                          low, high));
}

void requirePlace(const glm::dvec3& place, const char* what) {
  if (std::isfinite(place.x) && std::isfinite(place.y) && std::isfinite(place.z)) return;
  throw Error(fmt::format("tool {}: {} found, finite numbers expected", what, toText(place)));
}

void requireDirection(const glm::dvec3& direction, const char* what) {
  requirePlace(direction, what);
  if (direction == glm::dvec3(0))
    throw Error(fmt::format("tool {}: {} found, a direction expected", what, toText(direction)));
}

}  // namespace

void requireValid(const WorldRegion& region) {
  for (int axis = 0; axis < 3; ++axis) {
    const double low = region.low[axis], high = region.high[axis];
    if (low < high) continue;
    throw Error(
        fmt::format("region: min {:g} and max {:g} found on axis {}, max above min expected", low,
                    high, "xyz"[axis]));
  }
  if (region.lasso) requireValid(*region.lasso);
}

void requireValid(const ToolSource& source) {
  if (!source.from.empty() && !source.text.empty())
    throw Error("tool: a file or shelf:NAME and a text found, one of them expected");
  if (source.region) requireValid(*source.region);
  if (source.patch && source.patch->plane) {
    requirePlace(source.patch->plane->at, "plane");
    requireDirection(source.patch->plane->normal, "plane's normal");
  }
  if (source.pivot) requirePlace(*source.pivot, "pivot");
  if (source.contact) requireDirection(*source.contact, "contact");
  requireIn(source.cells, 4, 4096, "cells");
  requireIn(source.width, 1e-3, 1e6, "width");
  requireIn(source.height, 1e-3, 1e6, "height");
  requireIn(source.letterSize, 1e-3, 1e6, "size");
  requireIn(source.letterDepth, 1e-3, 1e6, "depth");
}

}  // namespace bozzetto
