// The key's shadow: taps of a depth map in a disk that the noise of the pixel turns. A slice reads
// few taps, others than its fellows, whose light stands elsewhere in the soft box.
uniform sampler2DShadow shadowMap;

float keyReaches(vec3 at, float radius, float bias) {
  vec3 p = (shadowFromCells * vec4(at, 1.)).xyz * .5 + .5;
  float angle = noise(gl_FragCoord.xy) * stage.w;
  mat2 turn = mat2(cos(angle), sin(angle), -sin(angle), cos(angle)) * radius;
  int count = int(shadowing.w);
  float sum = 0.;
  for (int i = 0; i < count; ++i) {
    sum += texture(shadowMap, vec3(p.xy + turn * taps[i].xy, p.z - bias));
  }
  return mix(1., sum / shadowing.w, shadowing.z);
}
