// Tools: glassy with bright rims, or solid under a lamp of their own.
in vec3 viewPosition;
in vec3 viewNormal;
out vec4 pixel;
uniform vec4 ink;
uniform vec4 glass;      // base, rim, exponent of the rim, glint
uniform vec4 solid;      // opacity of the lit body, part of all left behind clay
uniform float straight;  // 1 where all rays are parallel

void main() {
  vec3 n = normalize(viewNormal), v = normalize(mix(-viewPosition, vec3(0., 0., 1.), straight));
  float nv = abs(dot(n, v));
  vec3 key = normalize(vec3(-.58, .60, .55));
  float lit = .30 + .62 * max(dot(n, key), 0.) + .16 * pow(1. - nv, 3.);
  float glint = pow(max(dot(reflect(-v, n), key), 0.), 60.) * glass.w;
  float alpha = mix(glass.x + glass.y * pow(1. - nv, glass.z), 1., solid.x);
  vec3 c = mix(ink.rgb, ink.rgb * lit, solid.x) + glint;
  float all = clamp(alpha + glint * .8, 0., 1.) * ink.a;
  pixel = vec4(c, all * beforeClay(solid.y));
}
