// needs:
// Range reduction: returns x minus k quarter turns, in [-0.8, 0.8], and k modulo 4. pi / 2 is split
// into four parts (Cody and Waite); the first three have 8 bits, so their products with k are exact
// up to 1e5. Error 1e-7, above 1e5 6e-8 |x|.
vec2 circleReduce(float x) {
    x = clamp(x, -1.0e37, 1.0e37);
    float k = floor(x * 0.636619772 + 0.5);
    float r = (((x - k * 1.5703125) - k * 4.825592041015625e-4) - k * 1.2665987014770508e-6) - k * 9.92093597e-10;
    return vec2(clamp(r, -0.8, 0.8), k - 4.0 * floor(k * 0.25));
}
