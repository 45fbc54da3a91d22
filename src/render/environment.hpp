// What surrounds the clay as a function of direction, and what light makes of it: harmonics for
// matt clay, a sphere map of growing roughness for reflections. View space, linear RGB.
#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "bozzetto/render/studio.hpp"

namespace bozzetto {

/// Which soft boxes a sum counts: those whose light the lights already give are left out of the
/// ambient part.
enum class Boxes { all, noLights };

/// The surroundings of a studio. Equal ones look the same.
class Surroundings {
 public:
  explicit Surroundings(const Studio& studio);

  /// Radiance from `direction` (length 1).
  glm::vec3 at(glm::vec3 direction, Boxes boxes = Boxes::all) const;

  friend bool operator==(const Surroundings&, const Surroundings&) = default;

 private:
  struct Panel {
    glm::vec3 direction{0};
    SoftBox box;
    friend bool operator==(const Panel&, const Panel&) = default;
  };
  Environment kind_;
  float turn_;
  std::vector<Panel> panels_;  // of the lights
};

/// Cosine-weighted environment without the lights' boxes, as 9 coefficients ready for
/// c0 + c1·y + c2·z + c3·x + c4·xy + c5·yz + c6·(3z²−1) + c7·xz + c8·(x²−y²).
std::array<glm::vec3, 9> ambientHarmonics(const Surroundings& surroundings);

/// Sphere map, uv = .985·r.xy/(2·√(2(1 + r.z))) + ½; level n holds GGX roughness n/5.
struct SphereMap {
  static constexpr int kLevels = 6, kSide = 256;
  std::array<std::vector<glm::vec3>, kLevels> level;  ///< (256 >> n)² texels, rows from v = 0
};

/// `quick`: a sixth of the samples, for while a light is dragged.
enum class MapQuality { quick, good };
SphereMap reflectionMap(const Surroundings& surroundings, MapQuality quality);

}  // namespace bozzetto
