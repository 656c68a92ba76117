// An opaque surface hides a transparent fragment that is not in front of it. Two surfaces at one
// place, such as the floor and the face of a glass block that stands on it, have depths that differ
// by what computing makes of them, and one has to be in front everywhere: the opaque one. What the
// depths may differ by: each corner of a triangle is moved to a raster of 1/256 of a pixel, by half
// of that at most, which moves depth by its slope times so much, and so are those of the other
// surface; and 16 roundings of floats.
bool depthHidden(float depth, float opaque)
{
    return depth - fwidth(depth) / 256.0 <= opaque * (1.0 + 16.0 / 16777216.0);
}
