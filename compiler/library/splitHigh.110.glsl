// needs:
// The upper 12 bits or so of each number's mantissa: a product of two such numbers is exact where exp2 is of whole numbers.
vec3 splitHigh(vec3 x) {
    vec3 unit = exp2(floor(log2(max(abs(x), 1.0e-30))) - 10.0);
    return floor(x / unit) * unit;
}
