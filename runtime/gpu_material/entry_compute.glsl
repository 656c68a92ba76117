
// Compute entry point of a full-screen pass. The target's size need not be a multiple of the work
// group's.
layout(local_size_x = 8, local_size_y = 8) in;
layout(ENTRY_FORMAT) writeonly uniform image2D entry_target;
#ifdef ENTRY_APART
// Maps adjacent invocations to pixels of a row that are ENTRY_APART apart, 8 or a divisor of it. A
// row is split into parts of 8 * ENTRY_APART pixels; the last has the rest.
//
//     ENTRY_APART 8: invocations 0 1 2 ... 7 8 9 ... get pixels 0 8 16 ... 56 1 9 ...; in a row of
//         24 pixels, 0 1 2 3 4 5 ... get 0 8 16 1 9 17 ...
int entryApart(int x)
{
    const int part = 8 * ENTRY_APART;
    int first = x - x % part, columns = min(part, 8 * int(gl_NumWorkGroups.x) - first) /
        ENTRY_APART;
    return first + (x - first) % columns * ENTRY_APART + (x - first) / columns;
}
#endif
void main()
{
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
#ifdef ENTRY_APART
    pixel.x = entryApart(pixel.x);
#endif
    if (all(lessThan(pixel, imageSize(entry_target))))
        imageStore(entry_target, pixel, passPixel(pixel));
}
