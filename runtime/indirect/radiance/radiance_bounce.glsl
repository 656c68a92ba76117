// One more bounce of the radiance cache: each node traces rays through the voxels and reads the
// light of the nodes that they hit. The reflected light is first written to a texel of its own, and
// replaces that of the previous bounce after all nodes are done. Preceded by voxel_ray.glsl,
// radiance.glsl, radiance_place.glsl, indirect_basis.glsl.
uniform int bounce_step;   // 0: trace rays; 1: replace the previous bounce
uniform float bounce_far;  // ray length in voxels of the map

vec3 bounceDirection(int ray, uint seed, vec3 normal)
{
    uint random = seed * 747796405u + 2891336453u; // random numbers by O'Neill's PCG
    random = ((random >> (random >> 28 & 15u) + 4u) ^ random) * 277803737u;
    random ^= random >> 22;
    vec2 s = fract(vec2(float(ray) / float(RADIANCE_RAYS),
        float(bitfieldReverse(uint(ray)) >> 8) / 16777216.0) +
                   vec2(random & 65535u, random >> 16) / 65536.0);
    vec3 u, v;
    indirectBasis(normal, u, v);
    float turn = 6.28318530717959 * s.y, r = sqrt(s.x);
    return r * cos(turn) * u + r * sin(turn) * v + sqrt(1.0 - s.x) * normal;
}

void main()
{
    uint number = radianceNumber(), first = number * RADIANCE_TEXELS;
    if (number >= radiance_count) return;
    if (bounce_step == 1) {
        radiance_texels[first + 1u].xyz = radiance_texels[first + 3u].xyz;
        return;
    }
    vec3 even = radiance_texels[first + 2u].xyz, sum = vec3(0.0);
    if (radiance_texels[first].w < 0.0) return; // the node is within a closed mesh
    vec3 normal = normalize(radianceNormal(radiance_texels[first].w));
    vec3 place = float(1 << radiance_shift) * radiancePlace(number * LISTS_STRIDE, radiance_size);
    vec3 start = voxelStart(place, normal);
    // node numbers differ from run to run, voxels do not
    uint seed = radiance_nodes[number * LISTS_STRIDE] & RADIANCE_PLACE;
    for (int i = 0; i < RADIANCE_RAYS && even != vec3(0.0); i++) {
        float t;
        vec3 way = bounceDirection(i, seed, normal);
        bool full = voxelRay(start, way, bounce_far, t);
        RadianceRay ray = RadianceRay(place, start, way, full ? t : -1.0, voxelAt(start));
        RadianceSum met = radianceEnd(ray);
        sum += (met.direct + met.further) / max(met.weight, 1e-6);
    }
    radiance_texels[first + 3u] = vec4(even * sum / float(RADIANCE_RAYS), 0.0);
}
