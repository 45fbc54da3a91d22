// Lights and materials in numbers, as the shaders read them.
#pragma once
#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "bozzetto/render/camera.hpp"
#include "bozzetto/render/image.hpp"
#include "bozzetto/render/look.hpp"

namespace bozzetto {

/// std140 layout of studio.glsl.
struct StudioBlock {
  glm::vec4 harmonics[9];
  glm::vec4 lightDirection[Studio::kMostLights], lightColour[Studio::kMostLights],
      lightPlace[Studio::kMostLights];
  glm::vec4 material, toning, tint, options, counts, middle;

  friend bool operator==(const StudioBlock&, const StudioBlock&) = default;
};

/// Where the studio stands in front of the camera.
struct StudioPose {
  glm::mat3 worldFromView{1};
  glm::vec3 middle{0};  // the stage's centre, view space, stage units
};

/// The studio as `look` needs it.
StudioBlock studioFor(const Look& look, const std::array<glm::vec3, 9>& harmonics,
                      const StudioPose& pose);

/// From the clay to the key, view space, length 1; straight up without lights.
glm::dvec3 keyTowards(const Studio& studio, const Camera& camera);

/// The direction of a light fixed to the view after the studio's turn, length 1.
glm::vec3 turned(const glm::vec3& towards, float turn);

/// A painted ball, 256 × 256, rows from the bottom; its rim at .49 of the side.
Image paintedMatcap(Matcap matcap);
/// The same from somebody's picture of a ball that fills a square, rows from the top.
Image ballFromPicture(const Image& picture);

}  // namespace bozzetto
