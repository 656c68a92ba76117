// The pass light, deferred shading of every pixel. Preceded by lighting.glsl.
uniform sampler2D light_depth;

#ifdef SHADOW_PARTS
vec3 passOver(ivec2 pixel, out vec3 through)
{
    float depth = texelFetch(light_depth, pixel, 0).x;
    through = lightOver(vec3(depth > 0.0 ? 0.0 : 1.0));
    return depth > 0.0 ? lightOf(pixel, depth, unpackSurface(pixel)) : vec3(0.0);
}
#else
vec4 passPixel(ivec2 pixel)
{
    float depth = texelFetch(light_depth, pixel, 0).x;
    if (depth <= 0.0) return lightOfNothing(pixel);
    return vec4(lightOf(pixel, depth, unpackSurface(pixel)), 1.0);
}
#endif
