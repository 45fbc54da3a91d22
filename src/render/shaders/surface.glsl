// The clay at a pixel, as every look's fragment shader reads it.
in vec3 cells;
in vec3 viewPosition;
in vec3 viewNormal;
in vec3 viewBent;
in vec4 vertexColour;
in vec2 openness;
out vec4 pixel;

struct Clay {
  vec3 normal, view, bent, albedo;
  float open;             // 1 in the open, 0 deep inside
  vec3 bounced;           // the same with light that clay hands to clay
  float crease, ridge;    // cavity, split by sign
};

// Multi-bounce occlusion (Jimenez et al. 2016): creases of warm clay stay warm.
vec3 multiBounce(float open, vec3 albedo) {
  vec3 a = 2.0404 * albedo - .3324, b = -4.7951 * albedo + .6417, c = 2.7552 * albedo + .6903;
  return max(vec3(open), ((open * a + b) * open + c) * open);
}

Clay readClay() {
  Clay clay;
  clay.normal = normalize(viewNormal) * (gl_FrontFacing ? 1. : -1.);
  clay.view = normalize(mix(vec3(0., 0., 1.), -viewPosition, stage.z));
  clay.bent = viewBent;
  clay.albedo = linearFromSrgb(vertexColour.rgb);
  clay.open = mix(1., pow(openness.x, 1.25), toning.w);
  clay.bounced = multiBounce(clay.open, clay.albedo);
  clay.crease = max(openness.y, 0.) * toning.z;
  clay.ridge = max(-openness.y, 0.) * toning.z;
  return clay;
}

// Where a view-aligned matcap is read: the normal in a frame turned to the pixel's own ray.
vec2 matcapUv(Clay clay) {
  vec3 x = normalize(cross(vec3(0., 1., 0.), clay.view));
  return vec2(dot(clay.normal, x), dot(clay.normal, cross(clay.view, x))) * .49 + .5;
}
