// needs: splitHigh
// M root + offset - p, where p is that in float arithmetic: what rounding took. Columns and offset come as two floats each, h + r.
// Products are split so that they are exact, and sums are taken by whole parts, by 1/4096 and below: error 2^-33 and 2^-47 of the
// terms' sizes, for |p| < 2^22. A part is the nearest whole, so that what is below is exact; 0.49999997 is the float below 1/2, as
// 1/2 would take the float below 1/2 to 1.
vec3 affineTerm(vec3 h, float x, inout vec3 whole, inout vec3 part) {
    vec3 product = h * x;
    vec3 high = splitHigh(h);
    float xh = splitHigh(vec3(x)).x;
    vec3 low = h - high;
    float xl = x - xh;
    vec3 error = ((high * xh - product) + high * xl + low * xh) + low * xl;
    vec3 cell = floor(product + 0.49999997);
    vec3 digit = floor((product - cell) * 4096.0);
    whole += cell;
    part += digit;
    return (product - cell) - digit * (1.0 / 4096.0) + error;
}

vec3 affineRest(vec3 root, vec3 p, vec3 h0, vec3 r0, vec3 h1, vec3 r1, vec3 h2, vec3 r2, vec3 h3, vec3 r3) {
    vec3 whole = -floor(p + 0.49999997);
    vec3 digit = floor((p + whole) * 4096.0);
    vec3 part = -digit;
    vec3 below = -((p + whole) - digit * (1.0 / 4096.0));
    below += affineTerm(h0, root.x, whole, part) + affineTerm(h1, root.y, whole, part)
           + affineTerm(h2, root.z, whole, part) + affineTerm(h3, 1.0, whole, part);
    below += r0 * root.x + r1 * root.y + r2 * root.z + r3;
    return (whole + part * (1.0 / 4096.0)) + below;
}
