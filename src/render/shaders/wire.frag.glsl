// Edges of triangles as ink, fading where they would grow into a veil.
uniform vec4 ink;

void main() {
  float depth = mix(1., -viewPosition.z, stage.z);
  float cellPixels = extra.z / (depth * stage.x);
  pixel = vec4(ink.rgb, ink.a * clamp((cellPixels - 1.5) / 4.5, .15, 1.));
}
