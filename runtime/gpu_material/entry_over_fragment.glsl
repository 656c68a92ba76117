
// Entry point of a full-screen pass that blends over its target, as a fragment program: color +
// through * target, by dual-source blending.
layout(location = 0, index = 0) out vec4 entry_color;
layout(location = 0, index = 1) out vec4 entry_through;
void main()
{
    vec3 through;
    vec3 color = passOver(ivec2(gl_FragCoord.xy), through);
    if (color == vec3(0.0) && through == vec3(1.0)) discard; // the surface contributes nothing
    entry_color = vec4(color, 1.0);
    entry_through = vec4(through, 0.0);
}
