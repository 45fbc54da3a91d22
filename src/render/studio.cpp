#include "render/studio.hpp"

#include <glm/geometric.hpp>

namespace bozzetto {
namespace {

struct Material {
  float roughness = .36f, sigma = .45f, specular = 1.5f, coat = 0;
  glm::vec4 tint{1, 1, 1, 0};
};

Material materialOf(const Look& look) {
  Material m;
  switch (look.mode) {
    case Mode::glaze:
      m.coat = 1;
      break;
    case Mode::metal:
      m.roughness = look.metal == Metal::chrome ? .10f : .22f;
      m.tint = look.metal == Metal::chrome ? glm::vec4(1, .98f, .96f, 0)
                                           : glm::vec4(1.15f, .72f, .42f, 0);
      break;
    case Mode::glass:
      m.roughness = .06f;
      m.tint = {.55f, .85f, .95f, 0};
      break;
    default:
      break;
  }
  return m;
}

}  // namespace

StudioBlock studioFor(const Look& look, const std::array<glm::vec3, 9>& harmonics) {
  StudioBlock block{};
  for (std::size_t n = 0; n < harmonics.size(); ++n) block.harmonics[n] = {harmonics[n], 0};
  for (std::size_t n = 0; n < kLights.size(); ++n) {
    block.lightDirection[n] = {glm::normalize(kLights[n].direction), kLights[n].wrap};
    block.lightColour[n] = {kLights[n].colour, 0};
  }
  const Material m = materialOf(look);
  block.material = {m.roughness, m.sigma, m.specular, m.coat};
  block.toning = {.66f, .45f, 1, 1};
  block.tint = m.tint;
  return block;
}

}  // namespace bozzetto
