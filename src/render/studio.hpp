// Lights and materials in numbers.
#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "bozzetto/render/image.hpp"
#include "bozzetto/render/look.hpp"

namespace bozzetto {

struct Light {
  glm::vec3 direction;  ///< towards the light, view space, any length
  glm::vec3 colour;     ///< linear
  float wrap;           ///< how far round the form it reaches
};
inline constexpr int kKey = 0;
inline constexpr std::array<Light, 4> kLights{{
    {{-.58f, .60f, .55f}, {2.35f, 2.16f, 1.90f}, .10f},   // key
    {{.80f, .30f, -.52f}, {3.30f, 2.65f, 2.00f}, .12f},   // warm rim, right
    {{-.86f, .16f, -.50f}, {1.10f, 1.45f, 1.95f}, .15f},  // cool rim, left
    {{.75f, -.05f, .66f}, {.12f, .15f, .21f}, .50f},      // fill
}};

/// std140 layout of studio.glsl.
struct StudioBlock {
  glm::vec4 harmonics[9];
  glm::vec4 lightDirection[4], lightColour[4];
  glm::vec4 material, toning, tint;
};
/// The studio as `look` needs it.
StudioBlock studioFor(const Look& look, const std::array<glm::vec3, 9>& harmonics);

/// A painted ball, 256 × 256, rows from the bottom; its rim at .49 of the side.
Image paintedMatcap(Matcap matcap);

}  // namespace bozzetto
