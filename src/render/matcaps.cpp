// Four balls painted by formula: key from the upper left, rim from the right.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "render/environment.hpp"
#include "render/studio.hpp"

namespace bozzetto {
namespace {

using glm::mix;
using glm::vec2;
using glm::vec3;

vec3 srgb(unsigned hex) {
  return vec3(float(hex >> 16 & 255), float(hex >> 8 & 255), float(hex & 255)) / 255.f;
}

// What the brush asks at a point of the ball.
struct Ball {
  float key;      // 0…1, hard terminator
  float soft;     // 0…1, light reaching round
  float glint;    // tight highlight
  float sheen;    // wide highlight
  float rim;      // 0…1 towards the right edge
  float edge;     // 0 in the middle … 1 at the outline
  vec3 mirrored;  // environment, compressed

  explicit Ball(vec3 n);
};

Ball::Ball(vec3 n) {
  const vec3 light = glm::normalize(vec3(-.5f, .65f, .57f));
  const vec3 side = glm::normalize(vec3(.75f, .25f, -.35f));
  const vec3 r = n * (2 * n.z) - vec3(0, 0, 1);
  const float nl = glm::dot(n, light), rl = std::max(glm::dot(r, light), 0.f);
  key = std::clamp(nl, 0.f, 1.f);
  soft = std::clamp((nl + .45f) / 1.45f, 0.f, 1.f);
  glint = std::pow(rl, 50.f);
  sheen = std::pow(rl, 18.f);
  rim = glm::smoothstep(.25f, .75f, glm::dot(n, side));
  edge = std::pow(1 - n.z, 3.f);
  static const Surroundings studio{Studio()};
  const vec3 e = studio.at(r);
  mirrored = e / (1.f + e);
}

vec3 wax(const Ball& b) {
  vec3 c = mix(mix(srgb(0x3a0d0a), srgb(0xb23a22), b.soft), srgb(0xf0936a), b.key * b.key * .7f);
  c += vec3(1, .9f, .8f) * b.glint * .55f + srgb(0xff7a48) * b.rim * .35f;
  return c + srgb(0x8a1c10) * b.edge * .4f;
}

vec3 jade(const Ball& b) {
  vec3 c = mix(mix(srgb(0x0c2b22), srgb(0x4fa37a), b.soft), srgb(0xbfeccb), b.key * b.key * .75f);
  return c + vec3(.9f, 1, .95f) * b.glint * .7f + srgb(0x9fffd0) * (b.edge * .45f + b.rim * .15f);
}

vec3 plaster(const Ball& b) {
  const vec3 c = mix(srgb(0x6d6a70), srgb(0xe9e3dc), std::pow(b.soft, .8f));
  return c + srgb(0xffe4c8) * b.sheen * .12f + vec3(.25f, .28f, .35f) * b.edge * .5f;
}

vec3 pewter(const Ball& b) {
  const vec3 c = mix(srgb(0x2a2c33), srgb(0x9ba1ac), b.soft) * .35f;
  return c + b.mirrored * .85f + srgb(0xbcd4ff) * b.rim * .25f;
}

vec3 painted(Matcap matcap, vec3 n) {
  const Ball ball(n);
  switch (matcap) {
    case Matcap::wax:
      return wax(ball);
    case Matcap::jade:
      return jade(ball);
    case Matcap::plaster:
      return plaster(ball);
    case Matcap::pewter:
      break;
  }
  return pewter(ball);
}

std::uint8_t quantised(float v) { return std::uint8_t(std::clamp(v, 0.f, 1.f) * 255 + .5f); }

}  // namespace

Image paintedMatcap(Matcap matcap) {
  constexpr int side = 256;
  Image image(side, side);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      vec2 p = ((vec2(x, y) + .5f) / float(side) - .5f) / .49f;
      p *= std::min(1.f, .999f / std::max(glm::length(p), 1e-6f));
      const vec3 c = painted(matcap, {p.x, p.y, std::sqrt(1 - glm::dot(p, p))});
      image.at(x, y) = {quantised(c.x), quantised(c.y), quantised(c.z), 255};
    }
  }
  return image;
}

Image ballFromPicture(const Image& picture) {
  Image ball(256, 256);
  const auto from = [](int n, int size) {
    const double place = ((n + .5) / 256 - .5) / .98 + .5;
    return std::clamp(int(place * size), 0, size - 1);
  };
  for (int y = 0; y < ball.height; ++y) {
    for (int x = 0; x < ball.width; ++x) {
      ball.at(x, y) =
          picture.at(from(x, picture.width), picture.height - 1 - from(y, picture.height));
    }
  }
  return ball;
}

}  // namespace bozzetto
