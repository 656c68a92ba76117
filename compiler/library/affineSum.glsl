// needs: splitHigh
// Computes M root + offset to about 2^-30, for results below 2^22. Factors are split into two
// 12-bit numbers and a remainder, so every product is exact, fused multiply-add or not. `digits`
// counts multiples of 1/4096, `below` sums smaller terms.
void affineAdd(vec3 term, inout vec3 whole, inout vec3 digits, inout vec3 below) {
    vec3 cell = sign(term) * floor(abs(term));
    vec3 digit = (term - cell) * 4096.0;
    vec3 cut = sign(digit) * floor(abs(digit));
    whole += cell;
    digits += cut;
    below += (digit - cut) * (1.0 / 4096.0);
}

void affineColumn(vec3 a, vec3 b, vec3 c, float x, inout vec3 whole, inout vec3 digits, inout vec3 below) {
    float high = splitHigh(vec3(x)).x;
    float low = x - high;
    affineAdd(a * high, whole, digits, below);
    affineAdd(a * low, whole, digits, below);
    affineAdd(b * high, whole, digits, below);
    affineAdd(b * low, whole, digits, below);
    below += c * x;
}

void affineSum(vec3 root, vec3 a0, vec3 b0, vec3 c0, vec3 a1, vec3 b1, vec3 c1, vec3 a2, vec3 b2, vec3 c2,
               vec3 a3, vec3 b3, vec3 c3, out vec3 whole, out vec3 fraction) {
    vec3 digits = vec3(0.0);
    vec3 below = c3;
    whole = vec3(0.0);
    affineColumn(a0, b0, c0, root.x, whole, digits, below);
    affineColumn(a1, b1, c1, root.y, whole, digits, below);
    affineColumn(a2, b2, c2, root.z, whole, digits, below);
    affineAdd(a3, whole, digits, below);
    affineAdd(b3, whole, digits, below);
    vec3 carry = floor(digits * (1.0 / 4096.0) + below + 0.5);
    whole += carry;
    fraction = (digits * (1.0 / 4096.0) - carry) + below;
}
