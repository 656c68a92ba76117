// The path `compute`: a thread for each texel of a map writes its depth as a vertex; for the
// perfect triangulation also the two triangles of the quad to its right and above, whose corners go
// around from the one opposite the diagonal.
layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 0) writeonly buffer Depths { float written_depths[]; };
layout(std430, binding = 1) writeonly buffer Indices { uint written_indices[]; };
uniform sampler2DArray volume_depths;
uniform float volume_layer, volume_number; // layer of the map; index of the map among hybrid views

float depthAt(ivec2 texel)
{
    return texelFetch(volume_depths, ivec3(texel, int(volume_layer)), 0).x;
}

#ifdef QUADS
void writeQuad(ivec2 texel, int size)
{
    const ivec2 corners[4] = ivec2[](ivec2(0, 0), ivec2(1, 0), ivec2(1, 1), ivec2(0, 1));
    const int triangles[6] = int[](0, 1, 3, 1, 2, 3);
    vec4 depths;
    for (int i = 0; i < 4; i++)
        depths[i] = depthAt(texel + corners[i]);
    int turned = int(volumeTurned(depths));
    uint first = 6u * (uint(volume_number) * uint((size - 1) * (size - 1)) +
        uint(texel.y * (size - 1) + texel.x));
    for (int i = 0; i < 6; i++) {
        ivec2 corner = texel + corners[(triangles[i] + turned) % 4];
        written_indices[first + uint(i)] = uint(corner.y * size + corner.x);
    }
}
#endif

void main()
{
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    int size = textureSize(volume_depths, 0).x;
    if (texel.x >= size || texel.y >= size) return;
    written_depths[uint(volume_number) * uint(size * size) + uint(texel.y * size + texel.x)] =
        depthAt(texel);
#ifdef QUADS
    if (texel.x + 1 < size && texel.y + 1 < size) writeQuad(texel, size);
#endif
}
