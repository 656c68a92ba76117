// Light of a sky, from all directions. Its irradiance over pi is a polynomial of the unit normal n
// in world space: convolution with a clamped cosine keeps only band 1 and the even bands of the
// sky's spherical harmonics, which decay fast (Ramamoorthi and Hanrahan 2001). To band 6 that is
// b.n + the sum of c[i][j] x^i y^j z^(6-i-j): 3 and 28 numbers, within 0.3 % of the greatest
// irradiance for clear skies with the sun at 5 degrees and above. A lobe is sampled by SKY_SAMPLES
// look-ups in a cube map, each with the blur of its share of the lobe.
#ifndef LIGHT_SENDS
#define LIGHT_HAS_SKY
layout(std140) uniform Sky {
#include "sky.layout.def"
};
uniform samplerCube sky_map;

const int SKY_SAMPLES = 64;
const float SKY_PI = 3.14159265358979;

vec3 skyWorld(vec3 v)
{
    return vec3(dot(sky_world[0].xyz, v), dot(sky_world[1].xyz, v), dot(sky_world[2].xyz, v));
}

// Returns the irradiance over pi, for a surface with this normal. Horner's scheme in x, then in y,
// with the powers of z accumulated.
vec3 skyIrradiance(vec3 normal)
{
    vec3 n = skyWorld(normal), sum = vec3(0.0);
    int at = 0;
    for (int i = 6; i >= 0; i--) {
        vec3 inner = vec3(0.0);
        float z = 1.0;
        for (int j = 6 - i; j >= 0; j--) {
            inner = inner * n.y + sky_irradiance[at++].xyz * z;
            z *= n.z;
        }
        sum = sum * n.x + inner;
    }
    for (int i = 0; i < 3; i++) sum += sky_irradiance[at + i].xyz * n[i];
    return sky_light.xyz * max(sum, 0.0);
}

// Returns the integral of the sky times (w.u)^exponent (normal.u) over pi, u in both half spaces.
// Importance sampling: directions are distributed by the power, in a spiral; each represents 1 /
// SKY_SAMPLES of the power's integral, and reads the mipmap level of the cube map whose texels are
// as large as the solid angle around it.
vec3 skyLobe(vec3 normal, vec3 w, float exponent)
{
    vec3 n = skyWorld(normal), axis = skyWorld(w), sum = vec3(0.0);
    vec3 aside = normalize(abs(axis.z) < 0.7 ? cross(axis, vec3(0.0, 0.0, 1.0))
        : cross(axis, vec3(1.0, 0.0, 0.0)));
    vec3 across = cross(axis, aside);
    float texels = float(textureSize(sky_map, 0).x);
    for (int i = 0; i < SKY_SAMPLES; i++) {
        float share = (float(i) + 0.5) / float(SKY_SAMPLES), turn = 2.3999632 * float(i);
        float cosine = pow(share, 1.0 / (exponent + 1.0));
        float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
        vec3 u = cosine * axis + sine * (cos(turn) * aside + sin(turn) * across);
        // solid angle per sample
        float angle = 2.0 * SKY_PI * cosine / ((exponent + 1.0) * float(SKY_SAMPLES) * share);
        float level = 0.5 * log2(angle * 6.0 * texels * texels / (4.0 * SKY_PI));
        sum += textureLod(sky_map, u, max(level, 0.0)).xyz * max(dot(n, u), 0.0);
    }
    return sky_light.xyz * sum * (2.0 / ((exponent + 1.0) * float(SKY_SAMPLES)));
}
#else
vec3 lightFromSky(Seen seen) { return surfaceSky(seen.m); }
#endif
