
// The entry of a pass over all pixels. The target's size may be no multiple of the group's.
layout(local_size_x = 8, local_size_y = 8) in;
layout(ENTRY_FORMAT) writeonly uniform image2D entry_target;
void main()
{
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(pixel, imageSize(entry_target)))) imageStore(entry_target, pixel, passPixel(pixel));
}
