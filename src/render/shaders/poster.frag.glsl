// A picture standing in the scene.
in vec2 uv;
out vec4 pixel;
uniform sampler2D source;
uniform float opacity;
uniform float hidden;  // part of it left behind clay

void main() {
  pixel = texture(source, uv);
  pixel.a *= opacity * beforeClay(hidden);
}
