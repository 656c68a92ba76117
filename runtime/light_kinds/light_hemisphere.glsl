// Hemisphere lights, from all directions, by the formulas of scene.def; directions in eye space.
#ifndef LIGHT_SENDS
#define LIGHT_HAS_HEMISPHERE
layout(std140) uniform Hemisphere {
    vec4 hemisphere_up, hemisphere_above, hemisphere_below;
};

vec3 hemisphereMatt(vec3 normal)
{
    return mix(hemisphere_below.xyz, hemisphere_above.xyz,
        0.5 + 0.5 * dot(normal, hemisphere_up.xyz));
}

vec3 hemisphereMirrored(vec3 w)
{
    return mix(0.6 * hemisphere_below.xyz, hemisphere_above.xyz,
        smoothstep(-0.3, 0.5, dot(w, hemisphere_up.xyz)));
}

// Returns the radiance along a direction; its irradiance is hemisphereMatt.
vec3 lightAlongHemisphere(vec3 way)
{
    return dot(way, hemisphere_up.xyz) > 0.0 ? hemisphere_above.xyz : hemisphere_below.xyz;
}
#else
vec3 lightFromHemisphere(Seen seen) { return surfaceHemisphere(seen.m); }
#endif
