// Painted matcaps, display-referred: a picture of a lit ball, darkened by occlusion and creases.
uniform sampler2D matcap;

void main() {
  Clay clay = readClay();
  vec3 c = texture(matcap, matcapUv(clay)).rgb;
  c *= mix(vec3(1.), vertexColour.rgb, tint.w);
  c *= mix(1., clay.open, .75) * (1. - .4 * clay.crease + .15 * clay.ridge);
  pixel = vec4(c + dither(), 1.);
}
