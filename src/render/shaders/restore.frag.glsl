// The kept picture, for framebuffers that a plain copy cannot reach.
in vec2 uv;
out vec4 pixel;
uniform sampler2D source;

void main() { pixel = vec4(texture(source, uv).rgb, 1.); }
