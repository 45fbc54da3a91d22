// Metal: only the environment, tinted (Ferley's opaque environment mode).
void main() {
  Clay clay = readClay();
  float nv = max(dot(clay.normal, clay.view), 0.);
  vec3 r = reflect(-clay.view, clay.normal);
  float fresnel = .9 + .1 * pow(1. - nv, 5.);
  float open = mix(.25, 1., clamp(1.1 * clay.open * clay.open, 0., 1.));
  vec3 c = environment(r, material.x * 5.) * fresnel * open * tint.rgb * (1. - .3 * clay.crease);
  vec3 round = roundHighlights(clay.normal, clay.view, viewPosition, material.x + .08);
  c += round * tint.rgb * (.5 * open);
  pixel = vec4(tone(c * 1.15) + dither(), 1.);
}
