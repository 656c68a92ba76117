// Light of a surface that a ray hits in a voxel, by the radiance cache (radiance.h). Preceded by
// voxel_map.glsl.
//
// A surface at the border of a voxel may have its nodes in the next one along the ray: both are
// read. A node is weighted by its projected area: parallel rays along three axes sample a surface
// with a density of the sum of its normal's components, and the ray sees the cosine to the normal
// of it. A node counts only if its front faces the ray and the ray's point lies before its plane,
// so that light never leaks through thin walls.
uniform usamplerBuffer radiance_faces;
uniform samplerBuffer radiance_kept;
// voxels along an edge; each is 2^shift voxels of the map wide
uniform int radiance_size, radiance_shift;

struct RadianceRay {
    // in the map's units: point of the surface; start of the ray, a little off the surface;
    // direction of the ray, of any length
    vec3 point, start, way;
    float t;                // distance of the hit in multiples of `way`; < 0: no hit
    // The ray begins in a full voxel, as in a corner. voxelRay has then skipped ahead to the first
    // empty voxel, which may lie behind a thin wall.
    bool full;
};

struct RadianceSum {
    vec3 direct, further; // weighted sums: of direct light, and of further bounces
    float weight;
};

vec3 radianceNormal(float packed_)
{
    vec2 p = vec2(mod(packed_, 4096.0), floor(packed_ / 4096.0)) / 2047.5 - 1.0;
    vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    if (n.z < 0.0) n.xy = (1.0 - abs(n.yx)) * vec2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0);
    return n; // the normal has |x| + |y| + |z| = 1 and is not normalized
}

// Returns the number of a voxel's first node and, in the lowest 6 bits, the set of its sides; 0: no
// nodes.
uint radianceWord(ivec3 at)
{
    if (any(lessThan(at, ivec3(0))) || any(greaterThanEqual(at, ivec3(radiance_size)))) return 0u;
    return texelFetch(radiance_faces,
        RADIANCE_HEAD + (at.z * radiance_size + at.y) * radiance_size + at.x).x;
}

// Adds a node hit along the unit vector `way`, if its front faces the ray, `point` lies before its
// plane, and it does not lie within a closed mesh.
void radianceAdd(int node, vec3 point, vec3 way, inout RadianceSum sum)
{
    vec4 first = texelFetch(radiance_kept, node);
    vec3 normal = radianceNormal(first.w);
    float share = -dot(normal, way);
    vec4 second = texelFetch(radiance_kept, node + 1);
    if (first.w < 0.0 || share <= 0.0 ||
        dot(normal, point) * inversesqrt(dot(normal, normal)) <= second.w)
        return;
    sum.direct += share * first.xyz;
#if RADIANCE_TEXELS > 2
    sum.further += share * second.xyz;
#endif
    sum.weight += share;
}

// Returns the light at a ray's end. A ray that begins in a full voxel and meets another surface
// there, as in a corner, ends there: t is 0. If nodes are coarser than the map, their rays may have
// missed the surface at the end: then the adjacent voxels are read, too.
RadianceSum radianceEnd(inout RadianceRay ray)
{
    const float beside = 0.01;
    const uint sides = 63u;
    float scale = 1.0 / float(1 << radiance_shift);
    vec3 place = scale * (ray.start + max(ray.t, 0.0) * ray.way), point = scale * ray.point,
        way = normalize(ray.way);
    vec3 step_ = beside * way / max(max(abs(way.x), abs(way.y)), abs(way.z));
    ivec3 at = ivec3(floor(place + step_)), before = ivec3(floor(place - step_));
    RadianceSum sum = RadianceSum(vec3(0.0), vec3(0.0), 0.0), begun = sum;
    int around = 0;
    do {
        uvec3 words = uvec3(0u);
        if (around == 0 && ray.full) words.x = radianceWord(ivec3(floor(scale * ray.start)));
        if (ray.t >= 0.0)
            words.y = radianceWord(around == 0 ? at
                : at + ivec3((around - 1) % 3, (around - 1) / 3 % 3, (around - 1) / 9) - 1);
        if (ray.t >= 0.0 && around == 0 && before != at) words.z = radianceWord(before);
        ivec3 nodes = ivec3(words >> 6u);
        words &= sides;
        for (uint left = words.x | words.y << 6 | words.z << 12; left != 0u; left &= left - 1u) {
            bool first = (left & sides) != 0u, last = (left & (sides << 6 | sides)) == 0u;
            radianceAdd((first ? nodes.x : last ? nodes.z : nodes.y) * RADIANCE_TEXELS, point, way,
                sum);
            nodes += ivec3(first, !first && !last, last);
            // this was the last node of the start voxel
            if ((left & (left - 1u) & sides) == 0u && first) {
                begun = sum;
                sum = RadianceSum(vec3(0.0), vec3(0.0), 0.0);
            }
        }
        around++;
    } while (radiance_shift > 0 && ray.t >= 0.0 && begun.weight <= 0.0 && sum.weight <= 0.0 &&
        around <= 27);
    if (begun.weight > 0.0) {
        ray.t = 0.0;
        return begun;
    }
    return sum;
}
