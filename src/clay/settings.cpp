#include "bozzetto/clay/settings.hpp"

#include <cmath>
#include <string>

#include "bozzetto/base/error.hpp"

namespace bozzetto::clay {
namespace {

constexpr std::string_view kLayers[] = {"displacement", "conservation", "tension", "diffusion",
                                        "automaton"};
constexpr std::string_view kSchemes[] = {"projected", "paper", "paper_sweeps"};
constexpr std::string_view kRules[] = {"capped", "literal"};

template <class Enum, std::size_t Count>
std::optional<Enum> named(const std::string_view (&names)[Count], std::string_view name) {
  for (std::size_t n = 0; n < Count; ++n)
    if (names[n] == name) return static_cast<Enum>(n);
  return std::nullopt;
}

void requireIn(double value, double low, double high, const char* name) {
  if (value >= low && value <= high) return;
  throw Error("clay " + std::string(name) + ": " + std::to_string(value) + " found, a number in " +
              std::to_string(low) + " … " + std::to_string(high) + " expected");
}

}  // namespace

std::string_view toText(LayerKind layer) { return kLayers[static_cast<int>(layer)]; }
std::string_view toText(Scheme scheme) { return kSchemes[static_cast<int>(scheme)]; }
std::string_view toText(SharingRule rule) { return kRules[static_cast<int>(rule)]; }

std::optional<LayerKind> layerNamed(std::string_view name) {
  return named<LayerKind>(kLayers, name);
}
std::optional<Scheme> schemeNamed(std::string_view name) { return named<Scheme>(kSchemes, name); }
std::optional<SharingRule> sharingRuleNamed(std::string_view name) {
  return named<SharingRule>(kRules, name);
}

void requireValid(const Settings& settings) {
  requireIn(settings.stiffness, 0, 1, "stiffness");
  requireIn(settings.distanceOffset, 0, 1e6, "distance_offset");
  requireIn(settings.parting, 0, 4, "parting");
  requireIn(settings.crumb, 0, 1000, "crumb");
  requireIn(settings.iterations, 1, 1e8, "iterations");
  requireIn(settings.viscosity, 0, 16, "viscosity");
  requireIn(settings.profile[0], 0, 1, "profile");
  requireIn(settings.profile[1], 0, 1, "profile");
  requireIn(settings.walk, 0.1, 100, "walk");
  requireIn(settings.rate, 0, 1, "rate");
  requireIn(settings.threshold, 0, 8, "threshold");
  requireIn(settings.sweeps, 0, 10000, "sweeps");
}

}  // namespace bozzetto::clay
