#version 330 core
// matc 0.2.0: pass gbuffer, layout compact

layout(location = 0) out uvec4 fragment0;

void main() {
    fragment0 = gl_FrontFacing ? uvec4(4250709401u, 1522119063u, 831860058u, 3185u) : uvec4(4280666677u, 1522119063u, 831860058u, 3185u);
}
