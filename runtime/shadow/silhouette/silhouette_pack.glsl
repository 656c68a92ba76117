// Packs crossings into two bytes per texel: for the segments to the right and upwards, 0 without a
// crossing, else 1 plus 254 times the position on the segment, from 0 to 1. The error is at most
// 1/508 of a texel.
layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 3) readonly buffer Extents {
    uint extents[];
};
layout(rg8, binding = 0) writeonly uniform image2D silhouette_crossings;
uniform sampler2DArray silhouette_maps;
uniform mat4 silhouette_view;

float byteOf(ivec2 texel, int along)
{
    int size = int(silhouette_view[3].y), map = int(silhouette_view[3].z);
    uint extent = extents[(texel.y * size + texel.x) * 2 + along];
    if (extent == 0u) return 0.0;
    float first = texelFetch(silhouette_maps, ivec3(texel, map), 0).x;
    float second = texelFetch(silhouette_maps, ivec3(texel + ivec2(along == 0, along == 1), map),
        0).x;
    float part = float(extent - 1u) / 65534.0;
    return (1.0 + round((first > second ? part : 1.0 - part) * 254.0)) / 255.0;
}

void main()
{
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, ivec2(silhouette_view[3].y)))) return;
    imageStore(silhouette_crossings, texel, vec4(byteOf(texel, 0), byteOf(texel, 1), 0.0, 0.0));
}
