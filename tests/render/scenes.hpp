// Small solids given by a signed distance, as clay with its surface.
#pragma once
#include <functional>
#include <glm/vec3.hpp>

#include "bozzetto/render/picture.hpp"
#include "bozzetto/surface/surface.hpp"

namespace bozzetto::test {

using Distance = std::function<double(glm::dvec3)>;

struct Scene {
  Clay clay;
  Surface<8> surface;
};

/// Clay where the distance (cells, negative inside) is below 0, with a slope `softness` cells wide,
/// inside a box of half side `half` around `centre`; everything terracotta but for the colour's
/// green where x < centre, so that colours are seen too.
struct SceneOptions {
  int half = 40;
  double softness = 2;
  Key centre{};
};
Scene sceneOf(const Distance& distance, const SceneOptions& options = {});

Distance ball(glm::dvec3 centre, double radius);
Distance box(glm::dvec3 centre, glm::dvec3 half);
/// Smooth union over `k` cells.
Distance blended(Distance a, Distance b, double k);
Distance cut(Distance from, Distance tool);

/// A head of sorts: skull, jaw, nose, ears, eye sockets; mirror-symmetric in x, about 64 high.
Distance head();

}  // namespace bozzetto::test
