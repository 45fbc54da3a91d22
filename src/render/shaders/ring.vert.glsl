// A rectangle of clip space.
uniform vec4 bounds;  // left, bottom, right, top

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = vec4(mix(bounds.xy, bounds.zw, corner), 0., 1.);
}
