// What the model does to the floor: a pool of light, contact occlusion, a shadow. Premultiplied.
in vec2 onFloor;
in vec3 cells;
out vec4 pixel;
uniform sampler2D floorOcclusion;

const vec3 kPool = vec3(107., 100., 89.) / 255. * .35;

void main() {
  float r = length(onFloor) / floorPlane.w;
  float open = texture(floorOcclusion, onFloor / extra.x * .5 + .5).r;
  float shadow = keyReaches(cells, shadowing.y, .004);
  shadow = mix(1., shadow, 1. - smoothstep(.25, .75, r));
  float lit = mix(1., open, .9) * mix(1., shadow, .55);
  vec3 glow = kPool * exp(-7. * r * r) * lit;
  pixel = vec4(glow + dither(), (1. - lit) * .8 * (1. - smoothstep(.45, 1., r)));
}
