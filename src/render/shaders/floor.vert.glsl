// One large square under the model.
out vec2 onFloor;  // cells from the middle
out vec3 cells;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2. - 1.;
  onFloor = corner * floorPlane.w;
  cells = floorPlane.xyz + vec3(onFloor.x, 0., onFloor.y);
  gl_Position = clipFromCells * vec4(cells, 1.);
}
