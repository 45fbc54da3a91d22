// One slice added to the sum, or the sum brought to the picture.
in vec2 uv;
out vec4 pixel;
uniform sampler2D source;
uniform float weight;

void main() { pixel = texture(source, uv) * weight; }
