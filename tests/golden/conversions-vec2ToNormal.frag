#version 330 core
// matc 0.2.0: pass gbuffer, layout compact

layout(location = 0) out uvec4 fragment0;

void main() {
    fragment0 = gl_FrontFacing ? uvec4(86291012u, 0u, 9939089u, 645922816u) : uvec4(115019188u, 0u, 9939089u, 645922816u);
}
