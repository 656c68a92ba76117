// Vertex shader of the tools pass: transforms lines from view space to clip space.
layout(location = 0) in vec4 tools_point;
layout(location = 1) in vec3 tools_color;
layout(std140) uniform Tools {
    vec4 tools_clip;   // scale of x, y and z, and offset of z
    vec4 tools_w;      // clip space w: factor of z, and offset
    vec4 tools_ray;    // ViewSpace.ray of view_space.h
    vec4 tools_view;
    vec4 tools_ground; // the world's plane z = 0 in view space: dot(xyz, p) = w
};
flat out vec3 line_color;
flat out float line_ground;

void main()
{
    line_color = tools_color;
    line_ground = tools_point.w;
    gl_Position = vec4(tools_clip.xy * tools_point.xy, tools_clip.z * tools_point.z + tools_clip.w,
        tools_w.x * tools_point.z + tools_w.y);
}
