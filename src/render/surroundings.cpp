// The environments, each a formula: a photo studio's soft boxes, skies, a window wall, stripes.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include "render/environment.hpp"
#include "render/studio.hpp"

namespace bozzetto {
namespace {

using glm::mix;
using glm::smoothstep;
using glm::vec2;
using glm::vec3;

// Light of a panel with rounded corners and a soft rim, brighter towards its top.
vec3 panelLight(const SoftBox& box, vec3 front, vec3 d) {
  const float depth = glm::dot(d, front);
  if (depth < .05f) return vec3(0);
  const vec3 up = std::abs(front.y) > .9f ? vec3(0, 0, -1) : vec3(0, 1, 0);
  const vec3 right = glm::normalize(glm::cross(up, front)), top = glm::cross(front, right);
  const vec2 p = vec2(glm::dot(d, right), glm::dot(d, top)) / depth;
  const float corner = .4f * std::min(box.half.x, box.half.y);
  const float outside = glm::length(glm::max(glm::abs(p) - box.half + corner, vec2(0))) - corner;
  const float inside = 1 - smoothstep(-box.softness, .4f * box.softness, outside);
  return box.colour * inside * (.75f + .25f * std::clamp(p.y / box.half.y, -1.f, 1.f));
}

// Dark walls, a little light from above, warm bounce from the floor, fill and top boxes.
vec3 studioRoom(vec3 d) {
  static const SoftBox fill{{.26f, .70f}, .10f, {1.5f, 1.75f, 2.1f}};
  static const SoftBox top{{.62f, .42f}, .15f, {2.3f, 2.35f, 2.5f}};
  vec3 c = mix(vec3(.055f, .052f, .055f), vec3(.135f, .145f, .17f), smoothstep(-.35f, .25f, d.y));
  c = mix(c, vec3(.23f, .26f, .32f), smoothstep(.05f, .95f, d.y));
  c += vec3(.15f, .095f, .06f) * (1 - smoothstep(-1.f, -.25f, d.y));
  c += panelLight(fill, glm::normalize(vec3(.88f, .02f, .46f)), d);
  return c + panelLight(top, glm::normalize(vec3(.05f, .98f, .02f)), d);
}

// Value noise in two octaves, for clouds.
float hashed(float x, float y) {
  const float s = std::sin(x * 127.1f + y * 311.7f) * 43758.547f;
  return s - std::floor(s);
}
float noiseAt(float x, float y) {
  const float i = std::floor(x), j = std::floor(y);
  const float u = smoothstep(0.f, 1.f, x - i), v = smoothstep(0.f, 1.f, y - j);
  return mix(mix(hashed(i, j), hashed(i + 1, j), u), mix(hashed(i, j + 1), hashed(i + 1, j + 1), u),
             v);
}
float clouds(vec3 d, float low, float high) {
  if (d.y < .02f) return 0;
  const vec2 p = vec2(d.x, d.z) / (d.y + .25f) * 1.7f;
  const float n = .65f * noiseAt(p.x + 3, p.y + 7) + .35f * noiseAt(2.3f * p.x, 2.3f * p.y + 1);
  return smoothstep(low, high, n) * smoothstep(.02f, .3f, d.y);
}

// A blue sky with clouds over pale ground.
vec3 daylight(vec3 d) {
  const vec3 horizon(1.15f, 1.25f, 1.35f), zenith(.22f, .42f, .85f);
  const vec3 near(.09f, .08f, .065f), far(.36f, .33f, .28f);
  const vec3 sky = mix(horizon, zenith, std::pow(std::max(d.y, 0.f), .55f));
  const vec3 cloudy = mix(sky, vec3(1.7f, 1.7f, 1.75f), clouds(d, .45f, .75f));
  const vec3 ground = mix(far, near, std::pow(std::max(-d.y, 0.f), .5f));
  return mix(ground, cloudy, smoothstep(-.02f, .02f, d.y)) * .62f;
}

// The sun just gone on the right: embers along the horizon, violet above, dark earth.
vec3 dusk(vec3 d) {
  const float toSun = .5f + .5f * glm::dot(glm::normalize(vec3(d.x, 0, d.z) + 1e-4f),
                                           glm::normalize(vec3(.9f, 0, .3f)));
  const vec3 ember = mix(vec3(.55f, .20f, .28f), vec3(2.6f, 1.05f, .32f), toSun * toSun);
  const float height = std::max(d.y, 0.f);
  vec3 sky = mix(ember, vec3(.34f, .24f, .42f), smoothstep(0.f, .35f, height));
  sky = mix(sky, vec3(.09f, .12f, .27f), smoothstep(.2f, .95f, height));
  sky += ember * .5f * clouds(d, .5f, .8f);
  const vec3 ground = mix(ember * .10f, vec3(.022f, .018f, .022f), smoothstep(0.f, .5f, -d.y));
  return mix(ground, sky, smoothstep(-.03f, .03f, d.y)) * .85f;
}

// Panes of a window: 1 in the glass, 0 on the bars and the wall.
float panes(vec2 p, vec2 half, int across, int upwards) {
  const vec2 frame = glm::abs(p) - half;
  const float inside = 1 - smoothstep(-.02f, .005f, std::max(frame.x, frame.y));
  const vec2 cell = (p + half) / (2.f * half) * vec2(float(across), float(upwards));
  const vec2 toBar = glm::abs(cell - glm::floor(cell + .5f));
  const float bar = smoothstep(.05f, .09f, std::min(toBar.x, toBar.y));
  return inside * bar;
}

vec3 windowAt(vec3 d, vec3 towards, vec2 half, int across, int upwards) {
  const vec3 front = glm::normalize(towards);
  const float depth = glm::dot(d, front);
  if (depth < .08f) return vec3(0);
  const vec3 right = glm::normalize(glm::cross(vec3(0, 1, 0), front));
  const vec2 p = vec2(glm::dot(d, right), glm::dot(d, glm::cross(front, right))) / depth;
  const vec3 outside =
      mix(vec3(2.6f, 2.7f, 2.5f), vec3(4.6f, 5.0f, 5.6f), smoothstep(-half.y, half.y, p.y));
  return outside * panes(p, half, across, upwards);
}

// A workshop: one large window on the left, a small one on the right, wooden floor, white ceiling.
vec3 workshop(vec3 d) {
  vec3 c = mix(vec3(.16f, .135f, .11f), vec3(.30f, .29f, .27f), smoothstep(-.15f, .6f, d.y));
  const float boards =
      .8f +
      .2f * smoothstep(.04f, .12f,
                       std::abs(std::fmod(std::abs(d.x / std::min(d.y, -.05f)) * 2.f, 1.f) - .5f));
  c = mix(c, vec3(.20f, .12f, .065f) * boards, 1 - smoothstep(-.42f, -.34f, d.y));
  c += windowAt(d, {-.80f, .28f, .52f}, {.52f, .62f}, 3, 4);
  return c + windowAt(d, {.86f, .20f, -.30f}, {.26f, .46f}, 2, 3) * .8f;
}

// Stripes that circle the vertical axis.
vec3 zebra(vec3 d) {
  const float angle = std::acos(std::clamp(d.y, -1.f, 1.f)) * 5.f;
  const float wave = std::sin(angle * 3.14159265f);
  return mix(vec3(.025f, .027f, .03f), vec3(1.25f, 1.22f, 1.16f), smoothstep(-.12f, .12f, wave));
}

}  // namespace

Surroundings::Surroundings(const Studio& studio) : kind_(studio.environment), turn_(studio.turn) {
  for (const StudioLight& light : studio.lights) {
    if (light.frame == LightFrame::view && light.distance <= 0 && light.box.half.x > 0)
      panels_.push_back({turned(light.towards, turn_), light.box});
  }
}

vec3 Surroundings::at(vec3 direction, Boxes boxes) const {
  const vec3 d = turned(direction, -turn_);
  vec3 c(0);
  switch (kind_) {
    case Environment::studio:
      c = studioRoom(d);
      break;
    case Environment::daylight:
      c = daylight(d);
      break;
    case Environment::dusk:
      c = dusk(d);
      break;
    case Environment::workshop:
      c = workshop(d);
      break;
    case Environment::zebra:
      return boxes == Boxes::all ? zebra(d) : studioRoom(d);
  }
  if (boxes == Boxes::noLights) return c;
  for (const Panel& panel : panels_) c += panelLight(panel.box, panel.direction, direction);
  return c;
}

}  // namespace bozzetto
