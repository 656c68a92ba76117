// Tessellation control: sets the levels from the patch's numbers of parts.
layout(vertices = 3) out;
flat in int displace_corner[];
patch out int displace_number;

void main()
{
    if (gl_InvocationID != 0)
        return;
    vec4 parts = vec4(displaceParts(displace_drawn[displace_corner[0]].y));
    displace_number = displace_corner[0];
    gl_TessLevelOuter[0] = parts.x;
    gl_TessLevelOuter[1] = parts.y;
    gl_TessLevelOuter[2] = parts.z;
    gl_TessLevelInner[0] = parts.w;
}
