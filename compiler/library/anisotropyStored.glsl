// needs:
// The slot anisotropy, a (cos 2 t, sin 2 t), about another frame. `own` counts t from du toward dv; the result counts it from the vector T toward B, which
// the unit normal n alone makes, so that who reads n back has them: with w = 1 / (1 + n.z)
//   T = (1 - w n.x n.x, -w n.x n.y, -n.x), B = (-w n.x n.y, 1 - w n.y n.y, -n.y)
// are at right angles to n and to each other, and change with it everywhere but at (0, 0, -1), where T is (1, 0, 0). Of what du is in their plane, p, the
// angle is added twice: times p^2 / |p|^2 as complex numbers. Where dv lies to the right of it, seen against n, t counts the other way round.
// A du along n, or of no length, has no angle, and adds 0. Error 1e-6 where du is no closer to n than 0.05 and n no closer to (0, 0, -1).
//   n = (0, 0, 1), du = (0, 2, 0), dv = (-1, 0, 0), own = (.5, 0): p = (0, 1), p^2 = (-1, 0), the result (-.5, 0)
vec2 anisotropyStored(vec2 own, vec3 n, vec3 du, vec3 dv) {
    vec3 u = du * inversesqrt(max(dot(du, du), 1.0e-30)), v = dv * inversesqrt(max(dot(dv, dv), 1.0e-30));
    float across = dot(n.xy, n.xy);
    float below = n.z < 0.0 ? across / (1.0 - n.z) : 1.0 + n.z; // 1 + n.z
    vec2 p = u.xy - n.xy * (dot(n.xy, u.xy) / max(below, 1.0e-12) + u.z);
    float size = dot(p, p);
    vec2 turn = size < 1.0e-8 ? vec2(1.0, 0.0) : vec2(p.x * p.x - p.y * p.y, 2.0 * p.x * p.y) / max(size, 1.0e-8);
    vec2 a = dot(cross(u, v), n) < 0.0 ? vec2(own.x, -own.y) : own;
    return vec2(a.x * turn.x - a.y * turn.y, a.x * turn.y + a.y * turn.x);
}
