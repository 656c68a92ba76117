// End of a transparent material's fragment program for depth peeling: of the fragments in front of
// the layer behind, the depth test keeps the farthest. transparency.c has the preceding text. A
// fragment's key is its depth, as bits, which are ordered like depths, and the number of its
// triangle: of two at one depth the one drawn later is behind, so that none is lost.
uniform sampler2D peel_depth;   // depth of opaque surfaces
uniform usampler2D peel_behind; // keys of the layer behind this one
uniform float peel_stride;      // maximum number of triangles of an object, over 256
#ifdef PEEL_INSTANCES
flat in uint peel_object; // the object's index in drawing order
#else
uniform float peel_object;
#endif
layout(location = PEEL_TARGET) out uvec4 peel_key;

void main()
{
    surfaceMain();
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    uvec2 key = uvec2(floatBitsToUint(FRAGMENT_DEPTH),
        uint(peel_object) * uint(peel_stride) * 256u + uint(gl_PrimitiveID));
    uvec2 behind = texelFetch(peel_behind, pixel, 0).xy;
    bool hidden = depthHidden(FRAGMENT_DEPTH, texelFetch(peel_depth, pixel, 0).x);
    bool is_behind = key.x > behind.x || (key.x == behind.x && key.y < behind.y);
    if (surface_gone || hidden || !is_behind) discard;
    peel_key = uvec4(key, 0u, 0u);
}
