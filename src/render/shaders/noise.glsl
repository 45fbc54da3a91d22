// Interleaved gradient noise (Jimenez 2014).
float noise(vec2 pixel) {
    return fract(52.9829189 * fract(dot(pixel + part.xy, vec2(.06711056, .00583715))));
}

float dither() { return (noise(gl_FragCoord.xy) - .5) / 255. * stage.y; }
