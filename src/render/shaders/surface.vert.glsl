// Vertices of clay: cells from their chunk's origin; the origin is an integer count of cells from
// the anchor, so that vertices two chunks share land on the same bits.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normalCavity;
layout(location = 2) in vec4 colour;
layout(location = 3) in vec4 bentOcclusion;
layout(location = 4) in vec4 stiffness;
uniform vec3 chunkOrigin;

invariant gl_Position;
out vec3 cells;
out vec3 viewPosition;
out vec3 viewNormal;
out vec3 viewBent;
out vec4 vertexColour;
out float stiff;
out vec2 openness;  // unoccluded part, cavity

void main() {
  cells = position + chunkOrigin;
  gl_Position = clipFromCells * vec4(cells, 1.);
  viewPosition = (viewFromCells * vec4(cells, 1.)).xyz;
  viewNormal = normalCavity.xyz * mat3(worldFromView);
  viewBent = (bentOcclusion.xyz * 2. - 1.) * mat3(worldFromView);
  vertexColour = colour;
  stiff = stiffness.x;
  openness = vec2(bentOcclusion.w, normalCavity.w);
}
