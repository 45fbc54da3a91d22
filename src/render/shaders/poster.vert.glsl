// A picture standing in the scene.
layout(location = 0) in vec4 clip;
layout(location = 1) in vec2 uvOfVertex;
out vec2 uv;

void main() {
  uv = uvOfVertex;
  gl_Position = clip;
}
