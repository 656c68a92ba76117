
// The entry of a pass over all pixels. The target's size may be no multiple of the group's.
layout(local_size_x = 8, local_size_y = 8) in;
layout(ENTRY_FORMAT) writeonly uniform image2D entry_target;
#ifdef ENTRY_APART
// Invocations side by side get pixels ENTRY_APART, 8 or a part of it, apart along their row: in
// parts of it, the last as long as what is left.
//
//     of 8: invocations 0 1 2 ... 7 8 9 ... get pixels 0 8 16 ... 56 1 9 ...; of a row of 24, 0 1 2
//         3 4 5 ... get 0 8 16 1 9 17 ...
int entryApart(int x)
{
    const int part = 8 * ENTRY_APART;
    int first = x - x % part, columns = min(part, 8 * int(gl_NumWorkGroups.x) - first) / ENTRY_APART;
    return first + (x - first) % columns * ENTRY_APART + (x - first) / columns;
}
#endif
void main()
{
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
#ifdef ENTRY_APART
    pixel.x = entryApart(pixel.x);
#endif
    if (all(lessThan(pixel, imageSize(entry_target)))) imageStore(entry_target, pixel, passPixel(pixel));
}
