// Direct light that nodes of the radiance cache reflect diffusely. Preceded by lighting.glsl,
// LISTS_TEXELS, voxel_map.glsl, and radiance_place.glsl.
//
// If closed meshes overlap, parts of one's surface lie within the other: no ray should hit nodes
// there, and rays from them may leave on the other side. Such a node is found by the voxel before
// the surface along the axis. For a closed mesh that is the first voxel with its center outside the
// mesh, which is full only if another mesh fills it; for an open surface it is the voxel before the
// surface's own.
//
// The voxel of an alpha-tested surface was filled by samples, and its node has means over a voxel:
// the node counts unless nearly all of it is cut away.
const float RADIANCE_AWAY = 0.99;
uniform int radiance_size, radiance_shift;
uniform mat4 radiance_eye; // matrix from voxels to eye space

#define LISTS_WORD(word) radiance_nodes[node + uint(word)]

// Encodes a unit vector as an integer below 2^24: octahedral mapping in steps of 2/4095; max error
// 0.03 degrees.
float radianceDirection(vec3 n)
{
    n /= abs(n.x) + abs(n.y) + abs(n.z);
    vec2 folded = n.z < 0.0 ? (1.0 - abs(n.yx)) *
        vec2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0) : n.xy;
    vec2 whole = floor((folded * 0.5 + 0.5) * 4095.0 + 0.5);
    return whole.x + 4096.0 * whole.y;
}

bool radianceIsBuried(uint node, vec3 place)
{
    int axis = int(radiance_nodes[node] & 7u) >> 1, side = int(radiance_nodes[node] & 1u);
    bool body = (radiance_nodes[node] & RADIANCE_BODY) != 0u;
    vec3 fine = float(1 << radiance_shift) * place;
    ivec3 before = ivec3(fine);
    before[axis] = body ? int(floor(fine[axis] + 0.5)) - 1 + side : int(floor(fine[axis])) - 1 +
        2 * side;
    return voxelAt(vec3(before) + 0.5);
}

void main()
{
    const float pixel = 0.0625; // position error that shadows assume, in voxels
    uint number = radianceNumber(), node = number * LISTS_STRIDE, first = number * RADIANCE_TEXELS;
    if (number >= radiance_count) return;
    vec3 place = radiancePlace(node, radiance_size), normal = vec3(0.0);
    Surface surface = unpackTexels(LISTS_TEXELS);
    bool away = false;
#ifdef SURFACE_HAS_transparency
    away = dot(surface.transparency, vec3(1.0 / 3.0)) > RADIANCE_AWAY;
    surface.transparency = vec3(0.0); // lights the opaque part in full
#endif
    normal[int(radiance_nodes[node] & 7u) >> 1] = (radiance_nodes[node] & 1u) == 1u ? 1.0 : -1.0;
#ifdef SURFACE_HAS_normal
    normal = surface.normal;
    surface.normal = normalize(mat3(radiance_eye) * normal);
#endif
    vec3 turned = normalize(mat3(radiance_eye) * normal);
    Seen seen = Seen(ivec2(0), (radiance_eye * vec4(place, 1.0)).xyz,
        pixel * length(radiance_eye[0].xyz),
                     surfaceMatt(surfaceLit(surface, turned)));
    vec3 light = (lightIsFirst() ? lightEven(seen) : radiance_texels[first].xyz) +
        lightFromAll(seen);
    radiance_texels[first] = vec4(light, away || radianceIsBuried(node, place) ? -1.0
        : radianceDirection(normal));
    radiance_texels[first + 1u] = vec4(vec3(0.0), dot(normal, place));
#if RADIANCE_TEXELS > 2
    radiance_texels[first + 2u] = vec4(surfaceEven(seen.m), 0.0);
#endif
}
