#version 110
#extension GL_ARB_draw_buffers : enable
// Hartmann 2010, listing 4.2: what the thesis' compiler made of a checker of 1 and 0 under a UV transformation by 4 and 2.

varying vec2 uv;
varying vec3 normal;
varying float depth;
varying vec4 pos;
varying vec3 n_pos;
varying vec3 g_pos;

float packToFloat(vec2 val) {
    val = clamp(val, 0.0, 1.0);
    val.x = floor(val.x * 127.5) * 0.125;
    vec2 tmp = vec2(floor(val.x), fract(val.x));
    return (tmp.y + (floor(val.y * 127.5) * 0.0009765625) + (1.0)) * exp2(tmp.x);
}

vec2 encodeNormal(vec3 normal) {
    float f = sqrt(8.0 * normal.z + 8.0);
    return normal.xy / f + 0.5;
}

void main() {
    vec2 tmp0 = vec2(4.0 * (uv).s + 0.0 * (uv).t + 0.0,
                     0.0 * (uv).s + 2.0 * (uv).t + 0.0);

    vec3 n_normal = normalize(normal);
    if (!gl_FrontFacing) n_normal *= -1.0;
    vec3 emissive = vec3(0.0);
    vec3 diff_transp = vec3(0.0);

    gl_FragData[0] = vec4(encodeNormal(n_normal), 4.0, 0.0);
    gl_FragData[1] = vec4((mod(floor(2.0 * (tmp0).s) + floor(2.0 * (tmp0).t), 2.0) == 1.0 ?
                           vec3(1.0, 1.0, 1.0) : vec3(0.0, 0.0, 0.0)), packToFloat(emissive.rg));
    gl_FragData[2] = vec4(vec3(0.5), packToFloat(vec2(emissive.b, diff_transp.r)));
    gl_FragData[3] = vec4(vec3(0.0), packToFloat(diff_transp.gb));
}
