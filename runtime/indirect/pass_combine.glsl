// The pass combine: what is lit by lights that have a place gets light from all around, as far as
// its surroundings let it through, and light that comes by way of these. Before it stands
// lighting.glsl.
uniform sampler2D light_depth, indirect_open;
uniform float indirect_gain;

vec3 passOver(ivec2 pixel, out vec3 through)
{
    float depth = texelFetch(light_depth, pixel, 0).x;
    through = vec3(1.0);
    if (depth <= 0.0) return vec3(0.0);
    vec4 seen = texelFetch(indirect_open, pixel, 0);
    Seen surface = lightSeen(pixel, depth, unpackSurface(pixel));
#ifdef INDIRECT_DIMS
    through = vec3(seen.w);
#endif
    vec3 light = seen.w * lightAround(surface) + indirect_gain * surfaceEven(surface.m) * seen.xyz;
    return max(light, vec3(0.0)); // what is beside openness may be less than 0 (indirect_around.glsl)
}
