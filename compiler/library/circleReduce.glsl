// needs:
// x less a whole number of quarter turns, in [-0.8, 0.8], and that number modulo 4. pi / 2 in four parts (Cody and Waite), the
// first three of 8 bits, whose products with the number are exact up to 1e5: error 1e-7, beyond that 6e-8 |x|.
vec2 circleReduce(float x) {
    x = clamp(x, -1.0e37, 1.0e37);
    float k = floor(x * 0.636619772 + 0.5);
    float r = (((x - k * 1.5703125) - k * 4.825592041015625e-4) - k * 1.2665987014770508e-6) - k * 9.92093597e-10;
    return vec2(clamp(r, -0.8, 0.8), k - 4.0 * floor(k * 0.25));
}
