// What overlays know of the clay under them: its picture's depth, stretched over the view.
uniform sampler2D clayDepth;
uniform vec4 place;  // of the view: left and bottom (pixels), pixels of the picture per pixel

float clayDepthAt(vec2 pixel) {
  vec2 size = vec2(textureSize(clayDepth, 0));
  vec2 at = clamp((pixel - place.xy) * place.zw, vec2(.5), size - .5);
  return texelFetch(clayDepth, ivec2(at), 0).r;
}

// 1 in front of the clay, `hidden` behind it.
float beforeClay(float hidden) {
  return gl_FragCoord.z <= clayDepthAt(gl_FragCoord.xy) + 2e-6 ? 1. : hidden;
}
