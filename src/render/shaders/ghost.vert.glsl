// A tool in the scene.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 clipFromTool;
uniform mat4 viewFromTool;
uniform mat4 viewNormalFromTool;

invariant gl_Position;
out vec3 viewPosition;
out vec3 viewNormal;

void main() {
  gl_Position = clipFromTool * vec4(position, 1.);
  viewPosition = (viewFromTool * vec4(position, 1.)).xyz;
  viewNormal = mat3(viewNormalFromTool) * normal;
}
