#version 330 core
// matc 0.1.0: pass gbuffer, layout thesis

layout(location = 0) out vec4 fragment0;
layout(location = 1) out vec4 fragment1;
layout(location = 2) out vec4 fragment2;
layout(location = 3) out vec4 fragment3;

void main() {
    fragment0 = gl_FrontFacing ? vec4(0.7130888, 0.34026325, 198.99832, 65504.0) : vec4(0.16139887, 0.75382394, 198.99832, 65504.0);
    fragment1 = vec4(0.3529412, 0.47843137, 0.5254902, 1.0);
    fragment2 = vec4(0.5, 0.5, 0.5, 1.0);
    fragment3 = vec4(0.6, 0.6, 0.6, 1.0);
}
