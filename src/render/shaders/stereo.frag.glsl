// Both eyes in one picture.
in vec2 uv;
out vec4 pixel;
uniform sampler2D source;
uniform sampler2D other;
uniform vec4 view;  // left, bottom, width, height (pixels)
uniform int mode;   // 1 side by side, 2 rows, 3 anaglyph

void main() {
  vec3 l = texture(source, uv).rgb, r = texture(other, uv).rgb;
  vec3 c = vec3(dot(l, vec3(.299, .587, .114)), r.gb);
  float row = view.y + view.w - gl_FragCoord.y;
  if (mode == 2) c = mod(floor(row), 2.) < .5 ? l : r;
  if (mode == 1) {
    vec2 at = vec2(fract(uv.x * 2.), uv.y);
    c = uv.x < .5 ? texture(source, at).rgb : texture(other, at).rgb;
  }
  pixel = vec4(c, 1.);
}
