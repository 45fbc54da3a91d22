// A cool dark paper roll: light behind the model, darker rim, a floor that begins without a line.
in vec2 uv;
out vec4 pixel;

const vec3 kCentre = vec3(74., 78., 85.) / 255.;
const vec3 kRim = vec3(29., 31., 35.) / 255.;
const vec3 kFloor = vec3(42., 42., 44.) / 255.;

void main() {
  vec2 at = (part.xy + uv * part.zw) / viewport.xy;
  vec2 p = (at - viewport.zw) * vec2(viewport.x / viewport.y, 1.);
  float r = length(p * vec2(.86, 1.));
  vec3 c = mix(kCentre, kRim, smoothstep(0., 1.05, r));
  float ground = 1. - smoothstep(-.42, .02, at.y - viewport.w + .08);
  c = mix(c, kFloor, ground * .65 * extra.y);
  c *= 1. - .25 * smoothstep(.55, 1.2, r);
  pixel = vec4(c + dither() * 1.5, 1.);
}
