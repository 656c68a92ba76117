// Fragment shader of the tools pass: black in the light target, so that nothing behind a line
// shines through, and the line's color in the tools target, which the tone pass adds.
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

// Relative depth offset that puts a line in front of the surface on which the line lies.
const float NEARER = 1.0 / 65536.0;

// Returns the depth of the plane z = 0 at the pixel's center. A line in that plane covers pixels
// whose centers are up to half a pixel away from the line.
float groundDepth()
{
    vec3 ray = vec3((2.0 * gl_FragCoord.xy - tools_ray.zw) * tools_ray.xy, -1.0);
    if (tools_view.y > 0.0)
        return 1.0 + (tools_ground.w - dot(tools_ground.xy, ray.xy)) / tools_ground.z /
            tools_view.x;
    return tools_view.x * dot(tools_ground.xyz, ray) / tools_ground.w;
}

void main()
{
    float across = tools_view.y > 0.0 ? tools_ground.z : tools_ground.w;
    // undefined if the plane is edge-on
    float depth = line_ground > 0.5 && abs(across) > 1e-6 ? groundDepth() : gl_FragCoord.z;
    gl_FragDepth = depth * (1.0 + NEARER);
    tools_light = vec4(0.0, 0.0, 0.0, 1.0);
    tools_shown = vec4(line_color, 1.0);
}
