#include "bozzetto/solid/physics.hpp"

#include <cmath>
#include <string>

#include "bozzetto/base/error.hpp"

namespace bozzetto {
namespace {

void require(const char* name, double value, double low, double high) {
  if (value >= low && value <= high) return;
  throw Error(std::string("solid: found ") + name + " " + std::to_string(value) + ", expected " +
              std::to_string(low) + " to " + std::to_string(high));
}

}  // namespace

std::string_view toText(Solver solver) {
  constexpr std::string_view names[]{"standard", "live", "paper_explicit", "paper_implicit"};
  return names[static_cast<std::size_t>(solver)];
}

void requireValid(const SolidSettings& settings) {
  require("levels", settings.levels, 1, 3);
  require("time step", settings.timeStep, 1e-4, 100);
  require("damping", settings.damping, 0, 1000);
  require("stiffness", settings.stiffness, 1e-4, 1e6);
  require("angular stiffness", settings.angular, 0, 100);
  require("rope strength", settings.ropeStrength, 0, 1e6);
  require("creep", settings.creep, 0, 1000);
}

}  // namespace bozzetto
