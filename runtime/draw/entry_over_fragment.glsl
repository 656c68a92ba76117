
// The entry of a pass that lays something over all pixels, where there is no compute: color +
// through * what is there, by blending.
layout(location = 0, index = 0) out vec4 entry_color;
layout(location = 0, index = 1) out vec4 entry_through;
void main()
{
    vec3 through;
    vec3 color = passOver(ivec2(gl_FragCoord.xy), through);
    if (color == vec3(0.0) && through == vec3(1.0)) discard; // nothing is there
    entry_color = vec4(color, 1.0);
    entry_through = vec4(through, 0.0);
}
