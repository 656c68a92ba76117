// Debug view of a shadow volume: front faces orange, back faces blue, lighter the more they face
// the eye; or lines. Infinitely distant parts are omitted.
layout(std140) uniform Look {
    vec4 look_ray; // uniforms of view_space.h
    vec4 look_view;
};
in float volume_away; // 1: the map has no depth at any corner of the triangle
layout(location = 0) out vec4 look_light; // covered share of the light, like tools_light
layout(location = 1) out vec4 look_shown;

// Returns the cosine between the normal and the direction to the eye. Depth is linear over the
// picture, in the coordinates that tools_fragment.glsl calls the ray's x and y: its slopes give the
// normal.
float facing()
{
    vec2 slope = vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z)) / (2.0 * look_ray.xy);
    if (look_view.y > 0.0) return inversesqrt(1.0 + look_view.x * look_view.x * dot(slope, slope));
    vec2 ray = (2.0 * gl_FragCoord.xy - look_ray.zw) * look_ray.xy;
    vec3 normal = vec3(slope, dot(slope, ray) - gl_FragCoord.z);
    return min(gl_FragCoord.z * inversesqrt(max(dot(normal, normal) * (1.0 + dot(ray, ray)),
        1e-36)), 1.0);
}

void main()
{
    vec3 color = gl_FrontFacing ? vec3(0.95, 0.45, 0.1) : vec3(0.15, 0.35, 0.9);
#ifdef LINES
    float share = 1.0;
#else
    color *= 0.25 + 0.75 * facing();
#ifdef SOLID
    float share = 1.0;
#else
    float share = 0.5;
#endif
#endif
    if (volume_away > 0.9999) discard;
    look_light = vec4(0.0, 0.0, 0.0, share);
    look_shown = vec4(share * color, share);
}
