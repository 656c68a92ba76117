// needs:
// Finds the simplex around a point of a cell: hashes of its corners, and the point's offsets from
// them. Corner 1 is on the skewed lattice; corners 2 and 3 are steps along the axes of the largest
// and the two largest offsets (ties in axis order); corner 4 is a step along every axis. The cell's
// sum is divided by 3 exactly, so precision does not fall far from the origin. Corners have a
// period of 65536. A hash is the xor of three products; each axis needs only two, computed once and
// selected.
void simplexCorners(vec3 cell, vec3 d, out uvec4 hash, out vec4 dx, out vec4 dy, out vec4 dz) {
    cell -= 196608.0 * floor(cell * (1.0 / 196608.0));
    float sum = cell.x + cell.y + cell.z;
    float skew = floor((sum + 0.5) * (1.0 / 3.0));
    float rest = sum - 3.0 * skew;
    vec3 base = floor(d + (rest + d.x + d.y + d.z) * (1.0 / 3.0));
    vec3 x = d - base + (rest + base.x + base.y + base.z) * (1.0 / 6.0);
    bool xy = x.x >= x.y, yz = x.y >= x.z, xz = x.x >= x.z;
    bool most = xy && xz, some = xy || xz;
    bvec3 second = bvec3(most, yz && !most, !(yz || most));
    bvec3 third = bvec3(some, yz || !some, !(yz && some));
    uvec3 c = uvec3(ivec3(cell + skew + base));
    const uvec3 factor = uvec3(0xA6F9A1C3u, 0xF0729897u, 0xB16E8989u);
    uvec3 low = (c & 65535u) * factor;
    uvec3 high = ((c + 1u) & 65535u) * factor;
    hash = uvec4(low.x, second.x ? high.x : low.x, third.x ? high.x : low.x, high.x)
         ^ uvec4(low.y, second.y ? high.y : low.y, third.y ? high.y : low.y, high.y)
         ^ uvec4(low.z, second.z ? high.z : low.z, third.z ? high.z : low.z, high.z);
    dx = x.x + vec4(0.0, second.x ? -5.0 / 6.0 : 1.0 / 6.0, third.x ? -2.0 / 3.0 : 1.0 / 3.0, -0.5);
    dy = x.y + vec4(0.0, second.y ? -5.0 / 6.0 : 1.0 / 6.0, third.y ? -2.0 / 3.0 : 1.0 / 3.0, -0.5);
    dz = x.z + vec4(0.0, second.z ? -5.0 / 6.0 : 1.0 / 6.0, third.z ? -2.0 / 3.0 : 1.0 / 3.0, -0.5);
}
