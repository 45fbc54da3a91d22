// Colour spaces and the tone curve.
vec3 linearFromSrgb(vec3 c) { return c * (c * (c * .305306011 + .682171111) + .012522878); }

vec3 srgbFromLinear(vec3 c) {
  c = clamp(c, 0., 1.);
  vec3 a = sqrt(c), b = sqrt(a), d = sqrt(b);
  return max(.662002687 * a + .684122060 * b - .323583601 * d - .0225411470 * c, 0.);
}

// Narkowicz's fit of the ACES curve.
vec3 filmic(vec3 c) {
  return clamp((c * (2.51 * c + .03)) / (c * (2.43 * c + .59) + .14), 0., 1.);
}
