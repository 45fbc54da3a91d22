// A ball cut with the clay: a ring that hugs the form, a halo, a tint inside. Read from the clay's
// depth, so that a moving cursor draws no clay.
out vec4 pixel;
uniform mat4 cellsFromClip;
uniform vec4 ball;  // centre (cells from the anchor), radius
uniform vec4 ink;
uniform float weight;
uniform vec4 view;  // left, bottom, width, height (pixels)

float distanceAt(vec2 at, float depth) {
  vec4 p = cellsFromClip * vec4((at - view.xy) / view.zw * 2. - 1., depth * 2. - 1., 1.);
  return length(p.xyz / p.w - ball.xyz);
}

// How fast the distance changes over a step on the screen: the smaller side, because the other may
// lie beyond an edge of the clay.
float slope(vec2 stepped, float d) {
  vec2 p = gl_FragCoord.xy;
  float ahead = distanceAt(p + stepped, clayDepthAt(p + stepped));
  float behind = distanceAt(p - stepped, clayDepthAt(p - stepped));
  return min(abs(ahead - d), abs(d - behind)) / (stepped.x + stepped.y);
}

void main() {
  float depth = clayDepthAt(gl_FragCoord.xy);
  if (depth >= 1.) discard;
  float d = distanceAt(gl_FragCoord.xy, depth), r = ball.w;
  if (d > 1.5 * r + 20.) discard;
  vec2 texel = 1. / place.zw;
  float px = length(vec2(slope(vec2(texel.x, 0.), d), slope(vec2(0., texel.y), d))) + 1e-5;
  float away = abs(d - r) / px;
  float ring = (1. - smoothstep(.2 + .5 * weight, 1. + .7 * weight, away)) * .92 * weight;
  float halo = exp(-.22 * away) * .22 * weight;
  float x = clamp(1. - d * d / (r * r), 0., 1.);
  float tint = clamp((d < r ? .05 + .20 * x * x : 0.) * weight + halo, 0., 1.) * ink.a;
  float both = ring + tint * (1. - ring);
  if (both < .004) discard;
  pixel = vec4(mix(ink.rgb, vec3(1.), ring / both), both);
}
