// The clay at a pixel, as every look's fragment shader reads it.
in vec3 cells;
in vec3 viewPosition;
in vec3 viewNormal;
in vec3 viewBent;
in vec4 vertexColour;
in float stiff;           // painted: -1 soft, 1 stiff
in vec2 openness;
out vec4 pixel;

const vec3 kHeld = vec3(.035, .115, .145);  // linear; held clay is tinted towards it
// The same where stiffness is painted.
const vec3 kStiff = vec3(.08, .10, .42), kSoft = vec3(.75, .42, .05);

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

// A layer of paint: the environment in front of the clay's own colours, half transparent (Ferley
// §5).
vec3 painted(vec3 c, Clay clay, float open) {
  if (options.y == 0.) return c;
  vec3 r = reflect(-clay.view, clay.normal);
  return mix(c, environment(r, .8) * (.35 + .65 * open), options.y);
}

// Where cells meet: dark lines one and a half pixels wide, fading where cells become small.
float betweenCells() {
  vec3 width = max(fwidth(cells), 1e-6);
  vec3 away = abs(fract(cells + .5) - .5) / width;
  vec3 facing = abs(mat3(worldFromView) * normalize(viewNormal));
  away += step(.5, facing) * 1e3;
  float line = 1. - smoothstep(.5, 1.5, min(away.x, min(away.y, away.z)));
  return line * (1. - smoothstep(.15, .45, max(width.x, max(width.y, width.z))));
}

Clay readClay() {
  Clay clay;
  clay.normal = normalize(viewNormal) * (gl_FrontFacing ? 1. : -1.);
  if (options.x > 0.) clay.normal = normalize(cross(dFdx(viewPosition), dFdy(viewPosition)));
  clay.view = normalize(mix(vec3(0., 0., 1.), -viewPosition, stage.z));
  clay.bent = viewBent;
  clay.albedo = linearFromSrgb(vertexColour.rgb);
  clay.albedo = mix(clay.albedo, kHeld, .8 * options.z * (1. - vertexColour.a));
  clay.albedo = mix(clay.albedo, stiff > 0. ? kStiff : kSoft, .7 * options.z * abs(stiff));
  if (options.w > 0.) clay.albedo *= 1. - .7 * options.w * betweenCells();
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
