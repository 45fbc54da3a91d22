// The studio: up to eight lights, an environment as harmonics and as a sphere map, clay's answer.
// All directions are in view space, so what far lights do depends on the normal in the view only.
layout(std140) uniform Studio {
  vec4 harmonics[9];
  vec4 lightDirection[8];  // w: wrap
  vec4 lightColour[8];     // w: strength of its round highlight
  vec4 lightPlace[8];      // w: distance from the stage's centre, 0 far away
  vec4 material;           // roughness, Oren-Nayar sigma, specular level, clear coat
  vec4 toning;             // exposure, redness of the terminator, cavity, occlusion
  vec4 tint;
  vec4 options;            // flat (0 or 1), paint layer, tint of held clay, lines between cells
  vec4 counts;             // lights
  vec4 middle;             // the stage's centre
};
uniform sampler2D environmentMap;

const int kKey = 0;

struct Lit {
  vec3 key;       // diffuse light of the key, without shadow
  vec3 rest;      // diffuse light of all else
  vec3 specular;
  vec3 coat;
};

vec3 ambient(vec3 n) {
  vec3 sum = harmonics[0].rgb + harmonics[1].rgb * n.y + harmonics[2].rgb * n.z +
             harmonics[3].rgb * n.x + harmonics[4].rgb * (n.x * n.y) +
             harmonics[5].rgb * (n.y * n.z) + harmonics[6].rgb * (3. * n.z * n.z - 1.) +
             harmonics[7].rgb * (n.x * n.z) + harmonics[8].rgb * (n.x * n.x - n.y * n.y);
  return max(sum, 0.);
}

// Sphere map: the only singular direction points away from the viewer.
vec3 environment(vec3 r, float lod) {
  vec2 uv = .985 * r.xy / (2. * sqrt(2. * max(1. + r.z, 1e-3))) + .5;
  return textureLod(environmentMap, uv, lod).rgb;
}

vec3 tone(vec3 c) { return srgbFromLinear(filmic(c * toning.x)); }

// Improved Oren-Nayar (Fujii 2012): 1 for a smooth surface.
float roughDiffuse(float nl, float nv, float lv) {
  float a = 1. / (1. + .283 * material.y), b = material.y * a;
  float s = lv - nl * nv;
  float t = s > 0. ? max(max(nl, nv), .15) : 1.;
  return max(a + b * max(s, -.6) / t, 0.);
}

// Soft terminator, redder than the rest: light that went through wet clay.
vec3 wrapped(float nl, float wrap) {
  vec3 w = wrap + toning.y * vec3(.30, .07, .02);
  vec3 l = clamp((nl + w) / (1. + w), 0., 1.);
  l *= l * (1. - .35 * wrap) + .35 * wrap;
  return mix(l, vec3(max(nl, 0.)), .35);
}

// Split-sum environment BRDF (Lazarov 2013, Karis's fit) for F0 = .04.
float dielectric(float nv) {
  vec4 r = material.x * vec4(-1., -.0275, -.572, .022) + vec4(1., .0425, 1.04, -.04);
  float a = min(r.x * r.x, exp2(-9.28 * nv)) * r.x + r.y;
  vec2 ab = vec2(-1.04, 1.04) * a + r.zw;
  return .04 * ab.x + ab.y;
}

struct Beam {
  vec3 towards;
  vec3 colour;
};

// Near lights fade with the square of the distance; at the stage's centre all are as bright as far
// ones.
Beam beamOf(int i, vec3 at) {
  vec3 towards = lightPlace[i].xyz - at;
  float far = lightPlace[i].w, distance2 = max(dot(towards, towards), .04);
  if (far == 0.) return Beam(lightDirection[i].xyz, lightColour[i].rgb);
  return Beam(normalize(towards), lightColour[i].rgb * (far * far / distance2));
}

// Round highlights of lights that the environment does not show: GGX with Karis's cheap visibility,
// without Fresnel.
vec3 roundHighlights(vec3 n, vec3 v, vec3 at, float roughness) {
  vec3 sum = vec3(0.);
  float a = max(roughness * roughness, .01);
  for (int i = 0; i < int(counts.x); ++i) {
    if (lightColour[i].w == 0.) continue;
    Beam beam = beamOf(i, at);
    float nl = max(dot(n, beam.towards), 0.);
    vec3 h = normalize(beam.towards + v);
    float nh = max(dot(n, h), 0.), lh = max(dot(beam.towards, h), .1);
    float k = (nh * a * a - nh) * nh + 1.;
    sum += beam.colour * (nl * a * a / (k * k * 4. * lh * lh * (roughness + .5)));
  }
  return sum;
}

Lit studio(vec3 n, vec3 v, vec3 at) {
  Lit lit;
  float nv = clamp(dot(n, v), 1e-3, 1.);
  lit.key = vec3(0.);
  lit.rest = ambient(n);
  for (int i = 0; i < int(counts.x); ++i) {
    Beam beam = beamOf(i, at);
    float nl = dot(n, beam.towards);
    vec3 d = beam.colour * wrapped(nl, lightDirection[i].w)
        * roughDiffuse(nl, nv, dot(beam.towards, v));
    if (i == kKey) lit.key = d;
    else lit.rest += d;
  }
  vec3 r = reflect(-v, n);
  lit.specular = environment(r, material.x * 5.) * dielectric(nv) * material.z;
  lit.specular += roundHighlights(n, v, at, material.x) * (.04 * material.z);
  float coat = (.04 + .96 * pow(1. - nv, 5.)) * material.w;
  lit.coat = environment(r, .6) * coat;
  if (coat > 0.) lit.coat += roundHighlights(n, v, at, .12) * coat;
  return lit;
}
