// Inside the radius, with a soft rim: strips, dots, disks and their shadows alike.
in vec4 ink;
in vec4 shape;
in float hidden;
out vec4 pixel;

void main() {
  float inside = clamp((shape.z - length(shape.xy)) / shape.w + .5, 0., 1.);
  pixel = vec4(ink.rgb, ink.a * inside * beforeClay(hidden));
}
