// needs:
// Float version of perlinHash for GLSL without integers: 32 bits as (high, low) halves. A step is
// (c ^ b) - rotate_left(b): `turned` is b, its halves swapped from 16 bits on, `scale` the
// remaining power of two. All integers stay below 2^24, hence exact.
vec2 perlinHashStep(vec2 c, vec2 b, vec2 turned, float scale) {
    vec2 bits = vec2(0.0);
    float bit = 1.0;
    vec2 left = c;
    vec2 right = b;
    for (int i = 0; i < 16; i++) {
        vec2 halfLeft = floor(left * 0.5);
        vec2 halfRight = floor(right * 0.5);
        bits += bit * abs((left - 2.0 * halfLeft) - (right - 2.0 * halfRight));
        left = halfLeft;
        right = halfRight;
        bit *= 2.0;
    }
    vec2 over = floor(turned * (scale / 65536.0));
    vec2 rest = bits - ((turned - over * (65536.0 / scale)) * scale + over.yx);
    rest.x -= rest.y < 0.0 ? 1.0 : 0.0;
    return rest + vec2(rest.x < 0.0 ? 65536.0 : 0.0, rest.y < 0.0 ? 65536.0 : 0.0);
}

float perlinHash(vec3 cell, int count) {
    vec3 high = floor(cell * (1.0 / 65536.0));
    vec3 low = cell - 65536.0 * high + (48879.0 + 13.0 + 4.0 * float(count));
    vec3 carry = floor(low * (1.0 / 65536.0));
    high += carry + 57005.0;
    low -= 65536.0 * carry;
    high -= 65536.0 * floor(high * (1.0 / 65536.0));
    vec2 a = vec2(high.x, low.x);
    vec2 b = vec2(high.y, low.y);
    vec2 c = vec2(high.z, low.z);
    c = perlinHashStep(c, b, b, 16384.0);
    a = perlinHashStep(a, c, c, 2048.0);
    b = perlinHashStep(b, a, a.yx, 512.0);
    c = perlinHashStep(c, b, b.yx, 1.0);
    a = perlinHashStep(a, c, c, 16.0);
    b = perlinHashStep(b, a, a, 16384.0);
    c = perlinHashStep(c, b, b.yx, 256.0);
    return c.y - 16.0 * floor(c.y * (1.0 / 16.0));
}
