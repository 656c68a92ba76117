// The pass combine: adds ambient light, multiplied by ambient occlusion, and indirect light to
// surfaces lit by direct light. With INDIRECT_DIMS direct light is multiplied by ambient occlusion,
// too. Preceded by lighting.glsl.
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
    // the term that indirect_around.glsl adds to ambient occlusion may be negative
    return max(light, vec3(0.0));
}
