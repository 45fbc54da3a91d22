// Depth as the key sees it.
layout(location = 0) in vec3 position;
uniform vec3 chunkOrigin;

void main() { gl_Position = shadowFromCells * vec4(position + chunkOrigin, 1.); }
