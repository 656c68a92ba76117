// Which triangle a pixel sees: the vertex program.
layout(location = 0) in vec3 position;
uniform mat4 exact_clip;
void main() { gl_Position = exact_clip * vec4(position, 1.0); }
