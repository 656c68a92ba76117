// needs: latticeAxis latticePermute
// Finds the simplex around a point of a cell: hashes in [0, 761) of its corners, and the point's
// offsets from them. Corner 1 is on the skewed lattice, modulo 65536; corners 2 and 3 are steps
// along the axes of the largest and the two largest offsets (ties in axis order); corner 4 is a
// step along every axis. The cell's sum is divided by 3 exactly, so precision does not fall far
// from the origin. Period 196608 per axis.
void simplexCorners(vec3 cell, vec3 d, out vec4 hash, out vec4 dx, out vec4 dy, out vec4 dz) {
    cell -= 196608.0 * floor(cell * (1.0 / 196608.0));
    float sum = cell.x + cell.y + cell.z;
    float skew = floor((sum + 0.5) * (1.0 / 3.0));
    float rest = sum - 3.0 * skew;
    vec3 base = floor(d + (rest + d.x + d.y + d.z) * (1.0 / 3.0));
    vec3 x = d - base + (rest + base.x + base.y + base.z) * (1.0 / 6.0);
    vec3 first = cell + skew + base;
    first -= 65536.0 * floor(first * (1.0 / 65536.0));
    vec3 greater = vec3(step(x.yz, x.xy), 1.0 - step(x.z, x.x));
    vec3 second = min(greater, 1.0 - greater.zxy);
    vec3 third = max(greater, 1.0 - greater.zxy);
    vec3 c0 = latticeAxis(first).xyz;
    vec3 c1 = latticeAxis((first + 1.0) * (1.0 - step(65535.5, first + 1.0))).xyz;
    vec4 h = vec4(c0.x, mix(c0.x, c1.x, second.x), mix(c0.x, c1.x, third.x), c1.x);
    h = latticePermute(h + 17.0) + vec4(c0.y, mix(c0.y, c1.y, second.y), mix(c0.y, c1.y, third.y), c1.y);
    h = latticePermute(h) + vec4(c0.z, mix(c0.z, c1.z, second.z), mix(c0.z, c1.z, third.z), c1.z);
    hash = latticePermute(h);
    dx = x.x + vec4(0.0, 1.0 / 6.0 - second.x, 1.0 / 3.0 - third.x, -0.5);
    dy = x.y + vec4(0.0, 1.0 / 6.0 - second.y, 1.0 / 3.0 - third.y, -0.5);
    dz = x.z + vec4(0.0, 1.0 / 6.0 - second.z, 1.0 / 3.0 - third.z, -0.5);
}
