// needs:
// Octahedral encoding of a unit normal in [-1, 1]^2: n / (|x| + |y| + |z|), the lower half folded
// outward. (0, 0, 0) encodes as +z. sign() would be 0 at 0, where the fold needs 1. Error 2e-7.
vec2 encodeOctahedral(vec3 n) {
    vec2 p = n.xy / max(abs(n.x) + abs(n.y) + abs(n.z), 1.0e-30);
    vec2 side = vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0);
    return n.z < 0.0 ? (1.0 - abs(p.yx)) * side : p;
}
