// Clay and glaze in full: studio, shadow, occlusion, cavity.

// How much of the key a bent, half-closed hemisphere still sees.
float keyThroughOcclusion(Clay clay) {
  float facing = dot(clay.bent, lightDirection[kKey].xyz) * .5 + .5;
  float seen = smoothstep(.05, .75, clay.open * .62 + .38 * 1.6 * clay.open * facing + .05);
  return mix(1., seen, .6 * toning.w);
}

float specularOcclusion(Clay clay) {
  float nv = max(dot(clay.normal, clay.view), 0.);
  float power = exp2(-16. * material.x - 1.);
  return clamp(pow(nv + clay.open, power) - 1. + clay.open, 0., 1.);
}

void main() {
  Clay clay = readClay();
  Lit lit = studio(clay.normal, clay.view, viewPosition);
  vec3 bent = normalize(mix(clay.normal, clay.bent, .6));
  vec3 rest = max(lit.rest + .8 * (ambient(bent) - ambient(clay.normal)), 0.);

  vec3 lifted = cells + mat3(worldFromView) * clay.normal * (.012 * stage.x);
  float shadow = keyReaches(lifted, shadowing.x, .0022) * keyThroughOcclusion(clay);

  float shine = specularOcclusion(clay);
  vec3 c = clay.albedo * (lit.key * shadow + rest * clay.bounced);
  c += lit.specular * shine * mix(.55, 1., shadow) + lit.coat * shine * mix(.6, 1., shadow);
  c *= 1. - .42 * clay.crease;
  c += clay.ridge * .20 * (clay.albedo * .8 + .05) * (lit.key * shadow + rest * .5);
  c = painted(c, clay, shine);
  pixel = vec4(tone(c) + dither(), 1.);
}
