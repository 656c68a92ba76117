// Far-field expansion: the light of many points around c, at points p that are nearer to c than any
// of them. Without the cosine's clamp, a lamp at l gives a surface n.V, where V = (l - p) / |l -
// p|^3 is the gradient of 1 / |l - p| in p. With u = p - c and d = |l - c| that is a sum over k
// from 0 on of |u|^k / d^(k + 1) P_k(cos(u, l - c)), and P_k is a sum of products of 2 k + 1
// harmonics of each direction: so lamps add up in their harmonics alone. FAR_TERMS are those of k =
// 1 to N = 6. Remainder: the gradient of |u|^k P_k is at most k |u|^(k - 1) (Bernstein's and
// Szego's inequality for P_k as a polynomial of the angle's cosine), and with q = |u| / d the sum
// of k q^(k - 1) from N + 1 on is q^N (N + 1 - N q) / (1 - q)^2, times 1 / d^2.
// For example a lamp at (0, 0, 2), u = (0, 0, 1), n = (0, 0, 1): the exact value is 1, and 1/4 (1 +
// 2/2 + 3/4 + 4/8 + 5/16 + 6/32) = 0.9375; the error of 0.0625 equals the bound (7 - 3) / 64 /
// (1/4) / 4, which is tight if all lie on one line.
//
// Harmonics are complex, real and imaginary part in a vec2, by these recurrences (Epton and
// Dembart, 1995; P_km without (-1)^m):
//   R_km(u) = |u|^k P_km(cos t) e^(i m f) / (k + m)!
//   S_km(w) = (k - m)! P_km(cos t) e^(i m f), for a direction w
//   1 / |l - p| = sum of q^k / d (R_k0 S_k0 + 2 Re R_km Re S_km + 2 Im R_km Im S_km), m from 1 to
//                 k, where u is in units of the max |u|
//   along z:    ((k + 1)^2 - m^2) R_(k+1)m = (2 k + 1) z R_km - |u|^2 R_(k-1)m
//               S_(k+1)m = (2 k + 1) z S_km - (k^2 - m^2) S_(k-1)m
//   gradients:  d/dz R_km = R_(k-1)m
//               (d/dx - i d/dy) R_km = R_(k-1)(m-1)
//               (d/dx + i d/dy) R_km = -R_(k-1)(m+1)
#include "far.layout.def"
// Unrolled by macros: a compiler that keeps a loop would put the array into memory.
#define FAR_EACH_OF_24(f, k) \
    f(k) f(k + 1) f(k + 2) f(k + 3) f(k + 4) f(k + 5) f(k + 6) f(k + 7) f(k + 8) f(k + 9) \
    f(k + 10) f(k + 11) f(k + 12) f(k + 13) f(k + 14) f(k + 15) f(k + 16) f(k + 17) f(k + 18) \
    f(k + 19) f(k + 20) f(k + 21) f(k + 22) f(k + 23)
#define FAR_EACH(f) FAR_EACH_OF_24(f, 0) FAR_EACH_OF_24(f, 24)
#define FAR_EACH_LOBE(f) f(0) f(1) f(2) f(3) f(4) f(5) f(6)

// Returns the max error of the terms, for a lamp of irradiance 1 at c.
float farLeftOut(float q)
{
    float nearer = 1.0 / (1.0 - q), qq = q * q;
    return qq * qq * qq * (7.0 - 6.0 * q) * nearer * nearer;
}

vec2 farTimes(vec2 a, vec2 b) { return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x); }

#define FAR_ADD(at, s) sums[at] += p * (s);
#define FAR_ADD2(at, s) sums[at] += pp * (s).x; sums[at + 1] += pp * (s).y;

// Adds a lamp of irradiance `power` at c, from the direction w; `ratio` is the max |u| over its
// distance.
void farAdd(vec3 w, float ratio, vec3 power, inout vec3 sums[FAR_TERMS])
{
    vec2 xy = w.xy;
    float z = w.z, z3 = 3.0 * z, z5 = 5.0 * z, z7 = 7.0 * z;
    vec3 p = power, pp = 2.0 * p;
    FAR_ADD(0, z) FAR_ADD2(1, xy)
    p *= ratio, pp *= ratio;
    float s20 = z3 * z - 1.0;
    vec2 s21 = z3 * xy, s22 = 3.0 * farTimes(xy, xy);
    FAR_ADD(3, s20) FAR_ADD2(4, s21) FAR_ADD2(6, s22)
    p *= ratio, pp *= ratio;
    float s30 = z5 * s20 - 4.0 * z;
    vec2 s31 = z5 * s21 - 3.0 * xy, s32 = z5 * s22, s33 = 5.0 * farTimes(xy, s22);
    FAR_ADD(8, s30) FAR_ADD2(9, s31) FAR_ADD2(11, s32) FAR_ADD2(13, s33)
    p *= ratio, pp *= ratio;
    float s40 = z7 * s30 - 9.0 * s20;
    vec2 s41 = z7 * s31 - 8.0 * s21, s42 = z7 * s32 - 5.0 * s22, s43 = z7 * s33,
        s44 = 7.0 * farTimes(xy, s33);
    FAR_ADD(15, s40) FAR_ADD2(16, s41) FAR_ADD2(18, s42) FAR_ADD2(20, s43) FAR_ADD2(22, s44)
    float z9 = 9.0 * z, z11 = 11.0 * z;
    p *= ratio, pp *= ratio;
    float s50 = z9 * s40 - 16.0 * s30;
    vec2 s51 = z9 * s41 - 15.0 * s31, s52 = z9 * s42 - 12.0 * s32, s53 = z9 * s43 - 7.0 * s33,
        s54 = z9 * s44,
         s55 = 9.0 * farTimes(xy, s44);
    FAR_ADD(24, s50) FAR_ADD2(25, s51) FAR_ADD2(27, s52) FAR_ADD2(29, s53) FAR_ADD2(31,
        s54) FAR_ADD2(33, s55)
    p *= ratio, pp *= ratio;
    FAR_ADD(35, z11 * s50 - 25.0 * s40)
    FAR_ADD2(36, z11 * s51 - 24.0 * s41)
    FAR_ADD2(38, z11 * s52 - 21.0 * s42)
    FAR_ADD2(40, z11 * s53 - 16.0 * s43)
    FAR_ADD2(42, z11 * s54 - 9.0 * s44)
    FAR_ADD2(44, z11 * s55)
    FAR_ADD2(46, 11.0 * farTimes(xy, s55))
}

// Derivatives along n: of R_k0, from terms of degree k - 1; of R_km.
float farSlope(vec3 n, float same, vec2 above) { return n.z * same - dot(n.xy, above); }

vec2 farSlope(vec3 n, vec2 below, vec2 same, vec2 above)
{
    return n.z * same + 0.5 * (farTimes(n.xy, below) - farTimes(vec2(n.x, -n.y), above));
}

#define FAR_SLOPE(at, same, above) slopes[at] = farSlope(n, same, above);
#define FAR_SLOPE2(at, below, same, above) \
    slope = farSlope(n, below, same, above); \
    slopes[at] = slope.x; \
    slopes[at + 1] = slope.y;

// Derivatives of the harmonics along n, at u, whose length is at most 1.
void farSlopes(vec3 u, vec3 n, out float slopes[FAR_TERMS])
{
    const vec2 NONE = vec2(0.0);
    vec2 xy = u.xy, slope;
    float z = u.z, uu = dot(u, u), z5 = 5.0 * z;
    FAR_SLOPE(0, 1.0, NONE)
    FAR_SLOPE2(1, vec2(1.0, 0.0), NONE, NONE)
    vec2 r11 = 0.5 * xy;
    FAR_SLOPE(3, z, r11)
    FAR_SLOPE2(4, vec2(z, 0.0), r11, NONE)
    FAR_SLOPE2(6, r11, NONE, NONE)
    float r20 = (3.0 * z * z - uu) / 4.0;
    vec2 r21 = z * r11, r22 = farTimes(xy, r11) / 4.0;
    FAR_SLOPE(8, r20, r21)
    FAR_SLOPE2(9, vec2(r20, 0.0), r21, r22)
    FAR_SLOPE2(11, r21, r22, NONE)
    FAR_SLOPE2(13, r22, NONE, NONE)
    float r30 = (z5 * r20 - uu * z) / 9.0;
    vec2 r31 = (z5 * r21 - uu * r11) / 8.0, r32 = z * r22, r33 = farTimes(xy, r22) / 6.0;
    FAR_SLOPE(15, r30, r31)
    FAR_SLOPE2(16, vec2(r30, 0.0), r31, r32)
    FAR_SLOPE2(18, r31, r32, r33)
    FAR_SLOPE2(20, r32, r33, NONE)
    FAR_SLOPE2(22, r33, NONE, NONE)
    float z7 = 7.0 * z, z9 = 9.0 * z;
    float r40 = (z7 * r30 - uu * r20) / 16.0;
    vec2 r41 = (z7 * r31 - uu * r21) / 15.0, r42 = (z7 * r32 - uu * r22) / 12.0, r43 = z * r33,
         r44 = farTimes(xy, r33) / 8.0;
    FAR_SLOPE(24, r40, r41)
    FAR_SLOPE2(25, vec2(r40, 0.0), r41, r42)
    FAR_SLOPE2(27, r41, r42, r43)
    FAR_SLOPE2(29, r42, r43, r44)
    FAR_SLOPE2(31, r43, r44, NONE)
    FAR_SLOPE2(33, r44, NONE, NONE)
    float r50 = (z9 * r40 - uu * r30) / 25.0;
    vec2 r51 = (z9 * r41 - uu * r31) / 24.0, r52 = (z9 * r42 - uu * r32) / 21.0,
        r53 = (z9 * r43 - uu * r33) / 16.0,
         r54 = z * r44, r55 = farTimes(xy, r44) / 10.0;
    FAR_SLOPE(35, r50, r51)
    FAR_SLOPE2(36, vec2(r50, 0.0), r51, r52)
    FAR_SLOPE2(38, r51, r52, r53)
    FAR_SLOPE2(40, r52, r53, r54)
    FAR_SLOPE2(42, r53, r54, r55)
    FAR_SLOPE2(44, r54, r55, NONE)
    FAR_SLOPE2(46, r55, NONE, NONE)
}
