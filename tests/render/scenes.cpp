#include "scenes.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace bozzetto::test {

Scene sceneOf(const Distance& distance, const SceneOptions& options) {
  Scene scene;
  Edit<Clay::Block> edit(scene.clay.tree);
  const int blocks = (options.half + 7) / 8;
  for (int bi = -blocks; bi < blocks; ++bi) {
    for (int bj = -blocks; bj < blocks; ++bj) {
      for (int bk = -blocks; bk < blocks; ++bk) {
        const Key local{bi, bj, bk};
        Clay::Block& block = edit.write(Clay::Geometry::blockOf(options.centre) + local);
        for (int n = 0; n < Clay::Block::kCount; ++n) {
          const glm::dvec3 p(bi * 8 + n / 64, bj * 8 + n / 8 % 8, bk * 8 + n % 8);
          const double v = std::clamp(.5 - distance(p) / options.softness, 0., 1.);
          block.value[std::size_t(n)] = float(v);
          const Colour colour{0xac, std::uint8_t(p.x < 0 ? 0x70 : 0xa0), 0x52};
          block.attributes[std::size_t(n)] = packAttributes(colour);
        }
        block.updateRange();
      }
    }
  }
  edit.commit();
  scene.surface.rebuild(scene.clay);
  return scene;
}

Distance ball(glm::dvec3 centre, double radius) {
  return [=](glm::dvec3 p) { return glm::length(p - centre) - radius; };
}

Distance box(glm::dvec3 centre, glm::dvec3 half) {
  return [=](glm::dvec3 p) {
    const glm::dvec3 q = glm::abs(p - centre) - half;
    return glm::length(glm::max(q, glm::dvec3(0))) + std::min(0., std::max({q.x, q.y, q.z}));
  };
}

Distance blended(Distance a, Distance b, double k) {
  return [=](glm::dvec3 p) {
    const double da = a(p), db = b(p), h = std::max(k - std::abs(da - db), 0.) / k;
    return std::min(da, db) - h * h * h * k / 6;
  };
}

Distance cut(Distance from, Distance tool) {
  return [=](glm::dvec3 p) { return std::max(from(p), -tool(p)); };
}

Distance head() {
  const Distance skull = blended(ball({0, 8, 0}, 20), ball({0, -8, 6}, 14), 8);
  const Distance jaw = blended(skull, ball({0, -18, 12}, 5), 6);
  const Distance nose = blended(jaw, ball({0, 0, 21}, 4), 4);
  const Distance neck = blended(nose, box({0, -26, -2}, {9, 6, 9}), 6);
  const Distance ears = blended(neck, ball({20, 4, -2}, 5), 3);
  const Distance half = cut(ears, ball({8, 6, 20}, 4.5));
  return [=](glm::dvec3 p) { return half({std::abs(p.x), p.y, p.z}); };
}

}  // namespace bozzetto::test
