// Light of lamps that nodes of cached radiance reflect diffusely. Before it stand lighting.glsl,
// LISTS_TEXELS, voxel_map.glsl, and radiance_place.glsl.
//
// Where bodies cross, surfaces of one lie within the other: no ray should meet their nodes, and
// rays from them may get out on its other side. Of a body the first voxel before the surface along
// the axis has its middle outside of it, and is full only if another body has it there; of a
// surface that is the one before its own.
//
// The voxel of a cut-out surface was filled by samples, and its node has means over a voxel: it
// counts unless nearly all of it is cut away.
const float RADIANCE_AWAY = 0.99;
uniform int radiance_size, radiance_shift;
uniform mat4 radiance_eye; // the eye's space from voxels

#define LISTS_WORD(word) radiance_nodes[node + uint(word)]

// A unit vector as a whole number below 2^24: its octahedron's place in steps of 2/4095, 0.03
// degrees off at most.
float radianceDirection(vec3 n)
{
    n /= abs(n.x) + abs(n.y) + abs(n.z);
    vec2 folded = n.z < 0.0 ? (1.0 - abs(n.yx)) * vec2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0) : n.xy;
    vec2 whole = floor((folded * 0.5 + 0.5) * 4095.0 + 0.5);
    return whole.x + 4096.0 * whole.y;
}

bool radianceIsBuried(uint node, vec3 place)
{
    int axis = int(radiance_nodes[node] & 7u) >> 1, side = int(radiance_nodes[node] & 1u);
    bool body = (radiance_nodes[node] & RADIANCE_BODY) != 0u;
    vec3 fine = float(1 << radiance_shift) * place;
    ivec3 before = ivec3(fine);
    before[axis] = body ? int(floor(fine[axis] + 0.5)) - 1 + side : int(floor(fine[axis])) - 1 + 2 * side;
    return voxelAt(vec3(before) + 0.5);
}

void main()
{
    const float pixel = 0.0625; // of a voxel: shadows take it that places are off by no more
    uint number = radianceNumber(), node = number * LISTS_STRIDE, first = number * RADIANCE_TEXELS;
    if (number >= radiance_count) return;
    vec3 place = radiancePlace(node, radiance_size), normal = vec3(0.0);
    Surface surface = unpackTexels(LISTS_TEXELS);
    bool away = false;
#ifdef SURFACE_HAS_transparency
    away = dot(surface.transparency, vec3(1.0 / 3.0)) > RADIANCE_AWAY;
    surface.transparency = vec3(0.0); // what is left of it
#endif
    normal[int(radiance_nodes[node] & 7u) >> 1] = (radiance_nodes[node] & 1u) == 1u ? 1.0 : -1.0;
#ifdef SURFACE_HAS_normal
    normal = surface.normal;
    surface.normal = normalize(mat3(radiance_eye) * normal);
#endif
    vec3 turned = normalize(mat3(radiance_eye) * normal);
    Seen seen = Seen(ivec2(0), (radiance_eye * vec4(place, 1.0)).xyz, pixel * length(radiance_eye[0].xyz),
                     surfaceMatt(surfaceLit(surface, turned)));
    vec3 light = (lightIsFirst() ? lightEven(seen) : radiance_texels[first].xyz) + lightFromAll(seen);
    radiance_texels[first] = vec4(light, away || radianceIsBuried(node, place) ? -1.0 : radianceDirection(normal));
    radiance_texels[first + 1u] = vec4(vec3(0.0), dot(normal, place));
#if RADIANCE_TEXELS > 2
    radiance_texels[first + 2u] = vec4(surfaceEven(seen.m), 0.0);
#endif
}
