// From where and in what light the clay is looked at. World units; right-handed, Y up.
#pragma once
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "bozzetto/base/colour.hpp"

namespace bozzetto {

enum class SceneProjection : unsigned char { perspective = 0, orthographic = 1 };

/// Looks along its own −z at `target` from `distance` away; +y is up in the picture.
struct SceneCamera {
  glm::dvec3 target{0};
  glm::dquat worldFromCamera{1, 0, 0, 0};
  double distance = 0;      ///< 0: wherever all clay is in sight
  double fieldOfView = 35;  ///< degrees, the picture's height; 0 < · < 180
  SceneProjection projection = SceneProjection::perspective;

  friend bool operator==(const SceneCamera&, const SceneCamera&) = default;
};

/// Far away, so that only its direction counts.
struct Light {
  glm::dvec3 towards{0, 1, 0};  ///< from the clay to the light, in the camera's frame
  Colour colour{255, 255, 255};
  double intensity = 1;  ///< ≥ 0
  double softness = 0;   ///< 0 a point … 1 half the sky
  bool castsShadow = false;

  friend bool operator==(const Light&, const Light&) = default;
};

/// A box that tools do not leave, where somebody set one.
struct WorkspaceBox {
  glm::dvec3 low{0}, high{0};
  friend bool operator==(const WorkspaceBox&, const WorkspaceBox&) = default;
};

struct View {
  SceneCamera camera;
  std::vector<Light> lights;  ///< none: the studio's own
  std::optional<WorkspaceBox> workspace;

  friend bool operator==(const View&, const View&) = default;
};

}  // namespace bozzetto
