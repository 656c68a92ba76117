// Lines of the pass tools, from the eye's space to clip space.
layout(location = 0) in vec4 tools_point;
layout(location = 1) in vec3 tools_color;
layout(std140) uniform Tools {
    vec4 tools_clip;   // of x and y; of z, and what is added there
    vec4 tools_w;      // of z, and what is added
    vec4 tools_ray;    // view_space.h
    vec4 tools_view;
    vec4 tools_ground; // the world's plane z = 0 in the eye's space: dot(xyz, p) = w
};
flat out vec3 line_color;
flat out float line_ground;

void main()
{
    line_color = tools_color;
    line_ground = tools_point.w;
    gl_Position = vec4(tools_clip.xy * tools_point.xy, tools_clip.z * tools_point.z + tools_clip.w, tools_w.x * tools_point.z + tools_w.y);
}
