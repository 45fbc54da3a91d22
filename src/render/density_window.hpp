// A dense copy of what the cones of one neighbourhood can reach in every level of the pyramid:
// ten thousand samples then cost no tree look-ups.
#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "bozzetto/render/occlusion.hpp"

namespace bozzetto {

class DensityWindow {
 public:
  /// Around `cells`, as far as samples of `visibility` go from inside it; levels from `finest` up.
  DensityWindow(const OcclusionVolume& volume, const KeyBox& cells, int finest = 0);

  /// Occupancy at `p` (cells from the box's low corner), between two levels; 0 beyond the window.
  float sample(glm::vec3 p, float level) const;

  /// The same in one level by quadratic B-splines: no trace of the texels, which linear samples
  /// leave as rings on smooth clay. 27 texels.
  float smoothSample(glm::vec3 p, int level) const;

 private:
  struct Level {
    glm::vec3 first{0};  // place of texel (0,0,0), cells from the box's low corner
    glm::ivec3 count{0};
    float texelsPerCell = 1;
    std::vector<float> texels;

    float sample(glm::vec3 p) const;
    float smoothSample(glm::vec3 p) const;
  };

  std::array<Level, OcclusionVolume::kLevels> levels_;
  int finest_;
};

/// Light that comes through a cone: 1 in the open, 0 blocked.
struct Cone {
  glm::vec3 tip{0};        ///< cells from the window's low corner
  glm::vec3 direction{0};  ///< length 1
  float cell = 1;          ///< size of the finest detail, cells
  float reach = 200;       ///< cells
};
float visibility(const DensityWindow& window, const Cone& cone);

}  // namespace bozzetto
