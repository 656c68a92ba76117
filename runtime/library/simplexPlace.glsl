// needs:
// The simplex around a point of a cell: its first corner on the skewed lattice, modulo 65536, the steps to its second and third
// (the fourth is a step along every axis), and the point seen from the first. The sum of the cell is divided by 3 exactly, so that
// the place is as accurate far away as it is near; period 196608 an axis. Equal fractions are told apart by the order of the axes.
void simplexPlace(vec3 cell, vec3 d, out vec3 first, out vec3 second, out vec3 third, out vec3 x) {
    cell -= 196608.0 * floor(cell * (1.0 / 196608.0));
    float sum = cell.x + cell.y + cell.z;
    float skew = floor((sum + 0.5) * (1.0 / 3.0));
    float rest = sum - 3.0 * skew;
    vec3 base = floor(d + (rest + d.x + d.y + d.z) * (1.0 / 3.0));
    x = d - base + (rest + base.x + base.y + base.z) * (1.0 / 6.0);
    first = cell + skew + base;
    first -= 65536.0 * floor(first * (1.0 / 65536.0));
    vec3 greater = vec3(step(x.yz, x.xy), 1.0 - step(x.z, x.x));
    second = min(greater, 1.0 - greater.zxy);
    third = max(greater, 1.0 - greater.zxy);
}
