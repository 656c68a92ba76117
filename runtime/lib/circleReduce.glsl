// needs:
// x less a whole number of quarter turns, in [-0.8, 0.8], and that number modulo 4. pi / 2 in three parts (Cody and Waite): error
// 1e-7 for |x| up to 1e5, beyond that 6e-8 |x|.
vec2 circleReduce(float x) {
    x = clamp(x, -1.0e37, 1.0e37);
    float k = floor(x * 0.636619772 + 0.5);
    float r = ((x - k * 1.5703125) - k * 4.837512969970703125e-4) - k * 7.54978995489188e-8;
    return vec2(clamp(r, -0.8, 0.8), k - 4.0 * floor(k * 0.25));
}
