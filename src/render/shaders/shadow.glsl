// The key's shadow: taps of a depth map, turned by the noise of the pixel: 16 in a single frame,
// four in a slice, which adds to what other slices see of other lights.
uniform sampler2DShadow shadowMap;

const vec2 kTaps[16] = vec2[16](
    vec2(-.94, -.40), vec2(.94, -.77), vec2(-.09, -.93), vec2(.34, .29), vec2(-.91, .46),
    vec2(-.81, -.88), vec2(-.38, .28), vec2(.97, .44), vec2(.44, -.97), vec2(.54, -.47),
    vec2(-.26, -.42), vec2(.79, .19), vec2(-.24, 1.), vec2(-.81, .91), vec2(.20, .79),
    vec2(.14, -.14));

float keyReaches(vec3 at, float radius, float bias) {
  vec3 p = (shadowFromCells * vec4(at, 1.)).xyz * .5 + .5;
  float angle = noise(gl_FragCoord.xy) * 6.2831853;
  mat2 turn = mat2(cos(angle), sin(angle), -sin(angle), cos(angle));
  float sum = 0.;
  int count = int(shadowing.w), first = int(stage.w) * count;
  for (int n = first; n < first + count; ++n) {
    int i = n & 15;
    vec2 offset = turn * kTaps[i] * radius * (.35 + float(i) * .045);
    sum += texture(shadowMap, vec3(p.xy + offset, p.z - bias));
  }
  return mix(1., sum / shadowing.w, shadowing.z);
}
