// needs:
// The upper 12 bits or so of each mantissa: products of two are exact if exp2 is exact for
// integers.
vec3 splitHigh(vec3 x) {
    vec3 unit = exp2(floor(log2(max(abs(x), 1.0e-30))) - 10.0);
    return floor(x / unit) * unit;
}
