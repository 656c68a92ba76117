// needs:
// Jenkins' lookup3 hash of `count` (2 or 3) integers, |cell| <= 2^24, over 2^32 - 1, seeded with
// 0xDEADBEEF + 4 count + 13 as in OSL and MaterialX. For count 2, cell.z is 0. Error 1e-7.
// jenkinsPlaces also hashes the component index 0 to `dimensions` - 1.
uint jenkinsTurned(uint bits, int by) {
    return (bits << by) | (bits >> (32 - by));
}

float jenkinsEnd(uvec3 h) {
    h.z = (h.z ^ h.y) - jenkinsTurned(h.y, 14);
    h.x = (h.x ^ h.z) - jenkinsTurned(h.z, 11);
    h.y = (h.y ^ h.x) - jenkinsTurned(h.x, 25);
    h.z = (h.z ^ h.y) - jenkinsTurned(h.y, 16);
    h.x = (h.x ^ h.z) - jenkinsTurned(h.z, 4);
    h.y = (h.y ^ h.x) - jenkinsTurned(h.x, 14);
    h.z = (h.z ^ h.y) - jenkinsTurned(h.y, 24);
    return float(h.z) / 4294967296.0;
}

float jenkins(vec3 cell, int count) {
    return jenkinsEnd(uvec3(ivec3(cell)) + (0xDEADBEEFu + 13u + 4u * uint(count)));
}

vec3 jenkinsPlaces(vec3 cell, int dimensions) {
    if (dimensions < 3)
        return vec3(jenkins(vec3(cell.xy, 0.0), 3), jenkins(vec3(cell.xy, 1.0), 3), 0.0);
    uvec3 h = uvec3(ivec3(cell)) + (0xDEADBEEFu + 13u + 16u);
    h.x = (h.x - h.z) ^ jenkinsTurned(h.z, 4);
    h.z += h.y;
    h.y = (h.y - h.x) ^ jenkinsTurned(h.x, 6);
    h.x += h.z;
    h.z = (h.z - h.y) ^ jenkinsTurned(h.y, 8);
    h.y += h.x;
    h.x = (h.x - h.z) ^ jenkinsTurned(h.z, 16);
    h.z += h.y;
    h.y = (h.y - h.x) ^ jenkinsTurned(h.x, 19);
    h.x += h.z;
    h.z = (h.z - h.y) ^ jenkinsTurned(h.y, 4);
    h.y += h.x;
    return vec3(jenkinsEnd(h), jenkinsEnd(h + uvec3(1u, 0u, 0u)), jenkinsEnd(h + uvec3(2u, 0u, 0u)));
}
