// needs:
// The simplex around a point of a cell: hashes of its four corners, and the offsets of the point from each. The first corner is on the
// skewed lattice; the second and third are steps along the axes of the largest and of the two largest offsets (equal ones in the
// order of the axes), the fourth is a step along every axis. The sum of the cell is divided by 3 exactly, so that the place is as
// accurate far away as it is near. Period 65536 of a corner's coordinates: no more of them than their low halves counts.
void simplexCorners(vec3 cell, vec3 d, out uvec4 hash, out vec4 dx, out vec4 dy, out vec4 dz) {
    cell -= 196608.0 * floor(cell * (1.0 / 196608.0));
    float sum = cell.x + cell.y + cell.z;
    float skew = floor((sum + 0.5) * (1.0 / 3.0));
    float rest = sum - 3.0 * skew;
    vec3 base = floor(d + (rest + d.x + d.y + d.z) * (1.0 / 3.0));
    vec3 x = d - base + (rest + base.x + base.y + base.z) * (1.0 / 6.0);
    bool xy = x.x >= x.y, yz = x.y >= x.z, xz = x.x >= x.z;
    bvec3 second = bvec3(xy && xz, yz && !xy, !xz && !yz);
    bvec3 third = bvec3(xy || xz, yz || !xy, !xz || !yz);
    uvec3 c = uvec3(ivec3(cell + skew + base));
    uvec3 c1 = c + uvec3(second);
    uvec3 c2 = c + uvec3(third);
    uvec3 c3 = c + 1u;
    hash = ((uvec4(c.x, c1.x, c2.x, c3.x) & 65535u) | (uvec4(c.y, c1.y, c2.y, c3.y) << 16u)) * 0x2C1B3C6Du;
    hash ^= uvec4(c.z, c1.z, c2.z, c3.z) * 0x85EB0000u;
    hash ^= hash >> 13u;
    dx = x.x + vec4(0.0, 1.0 / 6.0 - float(second.x), 1.0 / 3.0 - float(third.x), -0.5);
    dy = x.y + vec4(0.0, 1.0 / 6.0 - float(second.y), 1.0 / 3.0 - float(third.y), -0.5);
    dz = x.z + vec4(0.0, 1.0 / 6.0 - float(second.z), 1.0 / 3.0 - float(third.z), -0.5);
}
