// The studio: four lights, a painted environment as harmonics and as a sphere map, clay's answer.
// All directions are in view space, so what comes out depends on the normal in the view only.
layout(std140) uniform Studio {
  vec4 harmonics[9];
  vec4 lightDirection[4];  // w: wrap
  vec4 lightColour[4];
  vec4 material;           // roughness, Oren-Nayar sigma, specular level, clear coat
  vec4 toning;             // exposure, redness of the terminator, cavity, occlusion
  vec4 tint;
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

Lit studio(vec3 n, vec3 v) {
  Lit lit;
  float nv = clamp(dot(n, v), 1e-3, 1.);
  lit.key = vec3(0.);
  lit.rest = ambient(n);
  for (int i = 0; i < 4; ++i) {
    vec3 l = lightDirection[i].xyz;
    float nl = dot(n, l);
    vec3 d = lightColour[i].rgb * wrapped(nl, lightDirection[i].w)
        * roughDiffuse(nl, nv, dot(l, v));
    if (i == kKey) lit.key = d;
    else lit.rest += d;
  }
  vec3 r = reflect(-v, n);
  lit.specular = environment(r, material.x * 5.) * dielectric(nv) * material.z;
  lit.coat = environment(r, .6) * (.04 + .96 * pow(1. - nv, 5.)) * material.w;
  return lit;
}
