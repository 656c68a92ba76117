// What a surface sends that a ray meets in a voxel, by cached radiance (radiance.h). Behind voxel_map.glsl.
//
// A surface that is half in a voxel may have its nodes in the next one along the ray: both are asked. A node counts by the area of it that the ray sees: what parallel rays along
// three axes see of a surface is as dense as the sum of its normal's lanes, and the ray sees as much of it as the cosine to its normal. It counts only if it is seen from its
// front, and if the ray begins before its plane: so no wall is too thin to keep light of its other side from its own.
uniform usamplerBuffer radiance_faces;
uniform samplerBuffer radiance_kept;
uniform int radiance_size, radiance_shift; // voxels along an edge: 2^shift of the map are one

struct RadianceRay {
    vec3 from, way; // the point from which it is sent, in voxels; of length 1
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

// Adds the nodes of a voxel, but for those that lie within a body.
void radianceAdd(ivec3 at, RadianceRay ray, inout RadianceSum sum)
{
    if (any(lessThan(at, ivec3(0))) || any(greaterThanEqual(at, ivec3(radiance_size)))) return;
    uint word = texelFetch(radiance_faces, RADIANCE_HEAD + (at.z * radiance_size + at.y) * radiance_size + at.x).x;
    int node = int(word >> 6) * RADIANCE_TEXELS;
    for (uint sides = word & 63u; sides != 0u; sides &= sides - 1u, node += RADIANCE_TEXELS) {
        vec4 first = texelFetch(radiance_kept, node);
        vec3 normal = radianceNormal(first.w);
        float share = -dot(normal, ray.way);
        if (first.w < 0.0 || share <= 0.0) continue;
        vec4 second = texelFetch(radiance_kept, node + 1);
        if (dot(normal, ray.from) * inversesqrt(dot(normal, normal)) <= second.w) continue;
        sum.direct += share * first.xyz;
        sum.further += share * second.xyz;
        sum.weight += share;
    }
}

// At a place on the side of a full voxel through which the ray comes in. Where nodes are coarser than the map, their rays may have missed what is there: then voxels around are asked.
RadianceSum radianceMet(vec3 place, RadianceRay ray)
{
    const float beside = 0.01;
    vec3 step_ = beside * ray.way / max(max(abs(ray.way.x), abs(ray.way.y)), abs(ray.way.z));
    ivec3 at = ivec3(floor(place + step_)), before = ivec3(floor(place - step_));
    RadianceSum sum = RadianceSum(vec3(0.0), vec3(0.0), 0.0);
    radianceAdd(at, ray, sum);
    if (before != at) radianceAdd(before, ray, sum);
    if (radiance_shift == 0 || sum.weight > 0.0) return sum;
    for (int k = 0; k < 27; k++) radianceAdd(at + ivec3(k % 3, k / 3 % 3, k / 9) - 1, ray, sum);
    return sum;
}

// A ray of a surface's point begins at `start`, a little off it, and meets a full voxel at t times its way: all in the map's units. The point says which planes are seen, as in
// corners of thin walls the start may be beyond one.
RadianceSum radianceAlong(vec3 point, vec3 start, vec3 way, float t)
{
    float scale = 1.0 / float(1 << radiance_shift);
    return radianceMet(scale * (start + t * way), RadianceRay(scale * point, normalize(way)));
}

// Whether a ray that begins in a full voxel meets a surface there: another one than its own, as in a corner. voxelRay would go on to the first empty voxel, and through a thin wall.
bool radianceBegins(vec3 point, vec3 start, vec3 way)
{
    if (!voxelAt(start)) return false;
    float scale = 1.0 / float(1 << radiance_shift);
    RadianceSum sum = RadianceSum(vec3(0.0), vec3(0.0), 0.0);
    radianceAdd(ivec3(scale * start), RadianceRay(scale * point, normalize(way)), sum);
    return sum.weight > 0.0;
}
