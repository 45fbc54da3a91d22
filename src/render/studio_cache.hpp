// What is computed from a studio once and kept: reflection map and harmonics, the studio baked on a
// ball, matcaps.
#pragma once
#include <list>
#include <map>

#include "render/environment.hpp"
#include "render/gl.hpp"
#include "render/stage_textures.hpp"
#include "render/studio.hpp"

namespace bozzetto {

class StudioCache {
 public:
  struct Map {
    Surroundings surroundings;
    MapQuality quality;
    std::array<glm::vec3, 9> harmonics;
    gl::Texture reflections;
  };

  /// A quick map where a good one is not there yet and `quality` is content with it.
  const Map& mapOf(const Studio& studio, MapQuality quality);

  /// The ball for this content, null where there is none.
  const gl::Texture* ball(const StudioBlock& block, const Map& map) const;
  const gl::Texture& keepBall(const StudioBlock& block, const Map& map, gl::Texture ball);

  const gl::Texture& matcapOf(const Look& look);

 private:
  static constexpr std::size_t kMostMaps = 4, kMostBalls = 8;
  struct Ball {
    StudioBlock block;
    GLuint map;
    gl::Texture texture;
  };

  std::list<Map> maps_;  // newest first
  std::list<Ball> balls_;
  std::map<Matcap, gl::Texture> painted_;
  std::shared_ptr<const Image> image_;
  gl::Texture imageTexture_;
};

}  // namespace bozzetto
