// Glass: nearest back faces, then nearest front faces (Ferley's semi-transparent mode).
void main() {
  Clay clay = readClay();
  float nv = abs(dot(clay.normal, clay.view));
  float edge = pow(1. - nv, 3.);
  vec3 mirror = environment(reflect(-clay.view, clay.normal), material.x * 5.);
  vec3 body = mix(tint.rgb, clay.albedo, .25) * (.10 + .22 * ambient(clay.normal) * clay.open);
  float alpha = gl_FrontFacing ? mix(.30, .96, edge) : mix(.10, .55, edge);
  alpha = clamp(alpha + .1 * dot(mirror, vec3(1.)), 0., .97);
  vec3 c = body + mirror * (.12 + .88 * edge) * (gl_FrontFacing ? 1. : .35);
  pixel = vec4(tone(c) + dither(), alpha);
}
