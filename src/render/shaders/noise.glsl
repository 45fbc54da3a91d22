// Interleaved gradient noise; every slice sees another one.
float noise(vec2 pixel) {
  pixel += stage.w * vec2(5.588238, 2.711);
  return fract(52.9829189 * fract(dot(pixel, vec2(.06711056, .00583715))));
}

float dither() { return (noise(gl_FragCoord.xy) - .5) / 255. * stage.y; }
