#include "render/studio_cache.hpp"

#include <algorithm>

namespace bozzetto {

// A light that is being dragged asks for a new map every frame: quick ones do for that.
const StudioCache::Map& StudioCache::mapOf(const Studio& studio, MapQuality quality) {
  const Surroundings wanted(studio);
  const auto found = std::find_if(maps_.begin(), maps_.end(), [&](const Map& map) {
    return map.surroundings == wanted &&
           (map.quality == MapQuality::good || quality == MapQuality::quick);
  });
  if (found != maps_.end()) {
    maps_.splice(maps_.begin(), maps_, found);
    return maps_.front();
  }
  maps_.push_front({wanted, quality, ambientHarmonics(wanted), reflectionTexture(wanted, quality)});
  if (maps_.size() > kMostMaps) maps_.pop_back();
  return maps_.front();
}

const gl::Texture* StudioCache::ball(const StudioBlock& block, const Map& map) const {
  for (const Ball& ball : balls_) {
    if (ball.map == map.reflections.get() && ball.block == block) return &ball.texture;
  }
  return nullptr;
}

const gl::Texture& StudioCache::keepBall(const StudioBlock& block, const Map& map,
                                         gl::Texture ball) {
  balls_.push_front({block, map.reflections.get(), std::move(ball)});
  if (balls_.size() > kMostBalls) balls_.pop_back();
  return balls_.front().texture;
}

// Wire shows its lines on plaster.
const gl::Texture& StudioCache::matcapOf(const Look& look) {
  if (look.matcapImage && look.mode == Mode::matcap) {
    if (image_ != look.matcapImage)
      imageTexture_ = imageTexture(ballFromPicture(*look.matcapImage));
    image_ = look.matcapImage;
    return imageTexture_;
  }
  const Matcap which = look.mode == Mode::wire ? Matcap::plaster : look.matcap;
  gl::Texture& texture = painted_[which];
  if (!texture) texture = imageTexture(paintedMatcap(which));
  return texture;
}

}  // namespace bozzetto
