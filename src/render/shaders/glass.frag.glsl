// Glass: nearest back faces, then nearest front faces (Ferley's semi-transparent mode), with what
// a solid piece would bend into view: the rims behind it light its edges from within.
void main() {
  Clay clay = readClay();
  float nv = abs(dot(clay.normal, clay.view));
  float edge = pow(1. - nv, 3.);
  vec3 mirror = environment(reflect(-clay.view, clay.normal), material.x * 5.);
  vec3 through = environment(refract(-clay.view, clay.normal, 1. / 1.3), 1.2);
  vec3 body = mix(tint.rgb, clay.albedo, .15) * (.06 + .18 * ambient(clay.normal) * clay.open);
  body += tint.rgb * through * (.20 + .35 * edge) * mix(.4, 1., clay.open);
  float alpha = gl_FrontFacing ? mix(.30, .96, edge) : mix(.10, .55, edge);
  alpha = clamp(alpha + dot(mirror, vec3(.1)) + dot(through, vec3(.05)), 0., .97);
  vec3 c = body + mirror * (.12 + .88 * edge) * (gl_FrontFacing ? 1. : .35);
  c += roundHighlights(clay.normal, clay.view, viewPosition, .12) * .06;
  pixel = vec4(tone(c) + dither(), alpha);
}
