// The pass tools: black in the light, so that nothing behind a line shines through it, and its
// colour beside that, which the pass tone adds.
layout(std140) uniform Tools {
    vec4 tools_clip;
    vec4 tools_w;
    vec4 tools_ray;
    vec4 tools_view;
    vec4 tools_ground;
};
flat in vec3 line_color;
flat in float line_ground;
layout(location = 0) out vec4 tools_light;
layout(location = 1) out vec4 tools_shown;

// By so much of its distance a line is in front of the surface that it lies on.
const float NEARER = 1.0 / 65536.0;

// A line covers pixels whose centres lie up to half a pixel beside it: what lies in the plane z = 0
// has the depth of that plane at the centre.
float groundDepth()
{
    vec3 ray = vec3((2.0 * gl_FragCoord.xy - tools_ray.zw) * tools_ray.xy, -1.0);
    if (tools_view.y > 0.0) return 1.0 + (tools_ground.w - dot(tools_ground.xy, ray.xy)) / tools_ground.z / tools_view.x;
    return tools_view.x * dot(tools_ground.xyz, ray) / tools_ground.w;
}

void main()
{
    float across = tools_view.y > 0.0 ? tools_ground.z : tools_ground.w;
    float depth = line_ground > 0.5 && abs(across) > 1e-6 ? groundDepth() : gl_FragCoord.z; // edge-on it has none
    gl_FragDepth = depth * (1.0 + NEARER);
    tools_light = vec4(0.0, 0.0, 0.0, 1.0);
    tools_shown = vec4(line_color, 1.0);
}
