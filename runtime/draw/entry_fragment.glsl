
// The entry of a pass over all pixels, where there is no compute.
layout(location = 0) out vec4 entry_color;
void main()
{
    entry_color = passPixel(ivec2(gl_FragCoord.xy));
}
