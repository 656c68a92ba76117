// Light of a surface that a ray hits in a voxel, by cached radiance (radiance.h). Behind
// voxel_map.glsl.
//
// A surface that is half in a voxel may have its nodes in the next one along the ray: both are
// asked. A node counts by the area of it that the ray sees: what parallel rays along three axes see
// of a surface is as dense as the sum of its normal's lanes, and the ray sees as much of it as the
// cosine to its normal. It counts only if it is seen from its front, and if the ray's point lies
// before its plane: so no wall is too thin to keep light of its other side from its own.
uniform usamplerBuffer radiance_faces;
uniform samplerBuffer radiance_kept;
uniform int radiance_size, radiance_shift; // voxels along an edge: 2^shift of the map are one

struct RadianceRay {
    vec3 point, start, way; // all in the map's units: the surface's point that sends it; where it begins, a little off; of any length
    float t;                // where it meets a full voxel, in multiples of its way; less than 0: nowhere
    bool full;              // it begins in a full voxel, as in a corner; voxelRay has gone on to the first empty one, which may lie behind a thin wall
};

struct RadianceSum {
    vec3 direct, further; // light of lamps, and of bounces, times
    float weight;
};

vec3 radianceNormal(float packed_)
{
    vec2 p = vec2(mod(packed_, 4096.0), floor(packed_ / 4096.0)) / 2047.5 - 1.0;
    vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    if (n.z < 0.0) n.xy = (1.0 - abs(n.yx)) * vec2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0);
    return n; // |x| + |y| + |z| is 1
}

// The first node of a voxel and, in the lowest 6 bits, its sides; 0: it has none.
uint radianceWord(ivec3 at)
{
    if (any(lessThan(at, ivec3(0))) || any(greaterThanEqual(at, ivec3(radiance_size)))) return 0u;
    return texelFetch(radiance_faces, RADIANCE_HEAD + (at.z * radiance_size + at.y) * radiance_size + at.x).x;
}

// Adds a node seen along `way`, of length 1, if it is seen from its front, `point` lies before it,
// and it does not lie within a body.
void radianceAdd(int node, vec3 point, vec3 way, inout RadianceSum sum)
{
    vec4 first = texelFetch(radiance_kept, node);
    vec3 normal = radianceNormal(first.w);
    float share = -dot(normal, way);
    vec4 second = texelFetch(radiance_kept, node + 1);
    if (first.w < 0.0 || share <= 0.0 || dot(normal, point) * inversesqrt(dot(normal, normal)) <= second.w) return;
    sum.direct += share * first.xyz;
#if RADIANCE_TEXELS > 2
    sum.further += share * second.xyz;
#endif
    sum.weight += share;
}

// Light at a ray's end. A ray that begins in a full voxel and meets a surface there other than its
// own, as in a corner, ends there: t is 0. If nodes are coarser than the map, their rays may have
// missed the surface at the end: then voxels around it are read.
RadianceSum radianceEnd(inout RadianceRay ray)
{
    const float beside = 0.01;
    const uint sides = 63u;
    float scale = 1.0 / float(1 << radiance_shift);
    vec3 place = scale * (ray.start + max(ray.t, 0.0) * ray.way), point = scale * ray.point, way = normalize(ray.way);
    vec3 step_ = beside * way / max(max(abs(way.x), abs(way.y)), abs(way.z));
    ivec3 at = ivec3(floor(place + step_)), before = ivec3(floor(place - step_));
    RadianceSum sum = RadianceSum(vec3(0.0), vec3(0.0), 0.0), begun = sum;
    int around = 0;
    do {
        uvec3 words = uvec3(0u);
        if (around == 0 && ray.full) words.x = radianceWord(ivec3(floor(scale * ray.start)));
        if (ray.t >= 0.0) words.y = radianceWord(around == 0 ? at : at + ivec3((around - 1) % 3, (around - 1) / 3 % 3, (around - 1) / 9) - 1);
        if (ray.t >= 0.0 && around == 0 && before != at) words.z = radianceWord(before);
        ivec3 nodes = ivec3(words >> 6u);
        words &= sides;
        for (uint left = words.x | words.y << 6 | words.z << 12; left != 0u; left &= left - 1u) {
            bool first = (left & sides) != 0u, last = (left & (sides << 6 | sides)) == 0u;
            radianceAdd((first ? nodes.x : last ? nodes.z : nodes.y) * RADIANCE_TEXELS, point, way, sum);
            nodes += ivec3(first, !first && !last, last);
            if ((left & (left - 1u) & sides) == 0u && first) { // the last of those where it begins
                begun = sum;
                sum = RadianceSum(vec3(0.0), vec3(0.0), 0.0);
            }
        }
        around++;
    } while (radiance_shift > 0 && ray.t >= 0.0 && begun.weight <= 0.0 && sum.weight <= 0.0 && around <= 27);
    if (begun.weight > 0.0) {
        ray.t = 0.0;
        return begun;
    }
    return sum;
}
