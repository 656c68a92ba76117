// The pass peel: lights a layer of transparent fragments. Follows lighting.glsl; the G-buffer is
// the layer's.
uniform usampler2D peel_keys;

const uint NOTHING = 0xFFFFFFFFu;

vec3 passOver(ivec2 pixel, out vec3 through)
{
    uint depth = texelFetch(peel_keys, pixel, 0).x;
    through = vec3(1.0);
    if (depth == NOTHING) return vec3(0.0);
    Surface surface = unpackSurface(pixel);
    through = surfaceThrough(surface, lightToEye(pixel));
#ifdef VEIL
    return vec3(0.0);
#else
    through = lightOver(through);
    return lightOf(pixel, uintBitsToFloat(depth), surface);
#endif
}
