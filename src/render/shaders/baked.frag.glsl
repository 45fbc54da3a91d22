// Clay and glaze on the fast path: the studio read from the picture that bake.frag made of it.
uniform sampler2D matcap;

void main() {
  Clay clay = readClay();
  vec4 baked = texture(matcap, matcapUv(clay));
  baked *= baked * 4.;
  vec3 c = clay.albedo * baked.rgb * clay.bounced;
  c = c * (1. - .42 * clay.crease + .16 * clay.ridge) + baked.a * clay.open;
  c = painted(c, clay, clay.open);
  pixel = vec4(tone(c) + dither(), 1.);
}
