// Reports whether an opaque surface hides a transparent fragment. Coincident surfaces, such as a
// floor and the face of a glass block on it, have depths that differ by rounding; the opaque one
// must win everywhere. Tolerance: each vertex is snapped to 1/256 of a pixel, an error of half of
// that, which moves depth by its slope; the other surface has the same error; plus 16 roundings of
// floats.
bool depthHidden(float depth, float opaque)
{
    return depth - fwidth(depth) / 256.0 <= opaque * (1.0 + 16.0 / 16777216.0);
}
