// Lights and surroundings of the clay, as values: what a person may move, colour and choose.
#pragma once
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string_view>
#include <vector>

#include "bozzetto/base/colour.hpp"

namespace bozzetto {

/// Surroundings that mirror in the clay, all made by formula. `zebra` is for judging surfaces: its
/// stripes break where curvature does.
enum class Environment { studio, daylight, dusk, workshop, zebra };

/// The name on the command line → environment. Throws Error naming the choices.
Environment parseEnvironment(std::string_view name);

/// Lights of `view` go with the viewer (+x right, +y up, +z towards the viewer), those of `scene`
/// stay with the clay.
enum class LightFrame { view, scene };

/// A lit panel that mirrors in the clay, at distance 1 from it; none when `half` is 0.
struct SoftBox {
  glm::vec2 half{0};     ///< tangents of half its angles
  float softness = .1f;  ///< of its rim
  glm::vec3 colour{0};   ///< linear
  friend bool operator==(const SoftBox&, const SoftBox&) = default;
};

struct StudioLight {
  glm::vec3 towards{0, 1, 0};  ///< from the clay to the light, any length but 0
  glm::vec3 colour{1};         ///< linear, strength included
  float wrap = .1f;            ///< how far round the form it reaches, 0…1
  LightFrame frame = LightFrame::view;
  float distance = 0;  ///< from the stage's centre, stage units; 0: far away
  SoftBox box;         ///< its highlight, far lights of `view` only; the others' is round
  friend bool operator==(const StudioLight&, const StudioLight&) = default;
};

/// The first light is the key: it alone casts a shadow.
struct Studio {
  static constexpr std::size_t kMostLights = 8;

  std::vector<StudioLight> lights;  ///< at most kMostLights
  Environment environment = Environment::studio;
  float turn = 0;         ///< radians; turns what is fixed to the view about the vertical
  float exposure = .66f;  ///< brightness of all, before the tone curve

  /// The lights made for the photo studio, or for another environment.
  Studio() : Studio(Environment::studio) {}
  explicit Studio(Environment environment);
  friend bool operator==(const Studio&, const Studio&) = default;
};

/// Where light `n` comes from, length 1, in the world; the studio's turn included.
glm::vec3 towardsInWorld(const Studio& studio, std::size_t n, const glm::mat3& worldFromView);
/// Makes it come from there.
void aimLight(Studio& studio, std::size_t n, const glm::vec3& towards,
              const glm::mat3& worldFromView);

/// A light as documents keep it: far away, fixed to the view.
struct PlainLight {
  glm::vec3 towards{0, 1, 0};
  Colour colour{255, 255, 255};
  double intensity = 1;  ///< 1: as bright as the photo studio's key
  double softness = 0;   ///< 0 a point … 1 half the sky
};
StudioLight studioLight(const PlainLight& plain);
/// What `plain` keeps of it: neither its box nor its distance.
PlainLight plainLight(const StudioLight& light);

}  // namespace bozzetto
