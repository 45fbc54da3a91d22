// The whole studio on one ball: square roots of a quarter of diffuse (rgb) and specular (a).
in vec2 uv;
out vec4 pixel;

void main() {
  vec2 p = (uv - .5) / .49;
  p *= min(1., .999 / max(length(p), 1e-6));
  vec3 n = vec3(p, sqrt(max(1. - dot(p, p), 0.)));
  Lit lit = studio(n, vec3(0., 0., 1.), middle.xyz);
  float shine = dot(lit.specular + lit.coat, vec3(1. / 3.));
  pixel = sqrt(clamp(vec4(lit.key * .93 + lit.rest, shine) / 4., 0., 1.));
}
