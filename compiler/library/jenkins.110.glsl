// needs:
// Float version of Jenkins' hash for GLSL without integers: 32 bits as (high, low) halves; all
// values stay below 2^24, hence exact. jenkinsTurned rotates left: from 16 bits on the halves swap,
// then multiply by a power of two.
vec2 jenkinsSum(vec2 a, vec2 b, float sign_) {
    vec2 sum = a + sign_ * b;
    float carry = floor(sum.y / 65536.0);
    sum += vec2(carry, -65536.0 * carry);
    return vec2(sum.x - 65536.0 * floor(sum.x / 65536.0), sum.y);
}

vec2 jenkinsEither(vec2 a, vec2 b) {
    vec2 bits = vec2(0.0);
    float bit = 1.0;
    for (int i = 0; i < 16; i++) {
        vec2 halfA = floor(a * 0.5);
        vec2 halfB = floor(b * 0.5);
        bits += bit * abs((a - 2.0 * halfA) - (b - 2.0 * halfB));
        a = halfA;
        b = halfB;
        bit *= 2.0;
    }
    return bits;
}

vec2 jenkinsTurned(vec2 b, float scale) {
    vec2 halves = scale < 65536.0 ? b : b.yx;
    float by = scale < 65536.0 ? scale : scale / 65536.0;
    vec2 over = floor(halves * (by / 65536.0));
    return (halves - over * (65536.0 / by)) * by + over.yx;
}

vec2 jenkinsStep(vec2 c, vec2 b, float scale) {
    return jenkinsSum(jenkinsEither(c, b), jenkinsTurned(b, scale), -1.0);
}

float jenkinsEnd(vec2 a, vec2 b, vec2 c) {
    c = jenkinsStep(c, b, 16384.0);
    a = jenkinsStep(a, c, 2048.0);
    b = jenkinsStep(b, a, 33554432.0);
    c = jenkinsStep(c, b, 65536.0);
    a = jenkinsStep(a, c, 16.0);
    b = jenkinsStep(b, a, 16384.0);
    c = jenkinsStep(c, b, 16777216.0);
    return (c.x * 65536.0 + c.y) / 4294967296.0;
}

vec2 jenkinsBegin(float number, float more) {
    float high = floor(number / 65536.0);
    return jenkinsSum(vec2(high, number - 65536.0 * high), vec2(57005.0, 48879.0 + 13.0 + more), 1.0);
}

float jenkins(vec3 cell, int count) {
    float more = 4.0 * float(count);
    return jenkinsEnd(jenkinsBegin(cell.x, more), jenkinsBegin(cell.y, more), jenkinsBegin(cell.z, more));
}

vec3 jenkinsPlaces(vec3 cell, int dimensions) {
    if (dimensions < 3)
        return vec3(jenkins(vec3(cell.xy, 0.0), 3), jenkins(vec3(cell.xy, 1.0), 3), 0.0);
    vec2 a = jenkinsBegin(cell.x, 16.0);
    vec2 b = jenkinsBegin(cell.y, 16.0);
    vec2 c = jenkinsBegin(cell.z, 16.0);
    a = jenkinsEither(jenkinsSum(a, c, -1.0), jenkinsTurned(c, 16.0));
    c = jenkinsSum(c, b, 1.0);
    b = jenkinsEither(jenkinsSum(b, a, -1.0), jenkinsTurned(a, 64.0));
    a = jenkinsSum(a, c, 1.0);
    c = jenkinsEither(jenkinsSum(c, b, -1.0), jenkinsTurned(b, 256.0));
    b = jenkinsSum(b, a, 1.0);
    a = jenkinsEither(jenkinsSum(a, c, -1.0), jenkinsTurned(c, 65536.0));
    c = jenkinsSum(c, b, 1.0);
    b = jenkinsEither(jenkinsSum(b, a, -1.0), jenkinsTurned(a, 524288.0));
    a = jenkinsSum(a, c, 1.0);
    c = jenkinsEither(jenkinsSum(c, b, -1.0), jenkinsTurned(b, 16.0));
    b = jenkinsSum(b, a, 1.0);
    return vec3(jenkinsEnd(a, b, c), jenkinsEnd(jenkinsSum(a, vec2(0.0, 1.0), 1.0), b, c), jenkinsEnd(jenkinsSum(a, vec2(0.0, 2.0), 1.0), b, c));
}
