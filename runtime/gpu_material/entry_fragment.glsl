
// Entry point of a full-screen pass as a fragment program.
layout(location = 0) out vec4 entry_color;
void main()
{
    entry_color = passPixel(ivec2(gl_FragCoord.xy));
}
