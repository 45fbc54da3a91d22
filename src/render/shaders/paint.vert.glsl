// Lines, dots and fills, placed on the screen already.
layout(location = 0) in vec4 clip;
layout(location = 1) in vec4 inkOfVertex;
layout(location = 2) in vec4 shapeOfVertex;
layout(location = 3) in float hiddenOfVertex;
out vec4 ink;
out vec4 shape;  // place (2), radius, width of the rim
out float hidden;

void main() {
  ink = inkOfVertex;
  shape = shapeOfVertex;
  hidden = hiddenOfVertex;
  gl_Position = clip;
}
