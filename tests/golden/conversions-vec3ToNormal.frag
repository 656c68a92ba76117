#version 330 core
// matc 0.1.0: pass gbuffer, layout thesis

layout(location = 0) out vec4 fragment0;
layout(location = 1) out vec4 fragment1;
layout(location = 2) out vec4 fragment2;
layout(location = 3) out vec4 fragment3;

void main() {
    fragment0 = gl_FrontFacing ? vec4(0.7387722, 0.32092085, 4.0, 65504.0) : vec4(0.17908283, 0.7406879, 4.0, 65504.0);
    fragment1 = vec4(0.32156864, 0.43529412, 0.3529412, 1.0);
    fragment2 = vec4(0.0, 0.0, 0.0, 1.0);
    fragment3 = vec4(0.0, 0.0, 0.0, 1.0);
}
