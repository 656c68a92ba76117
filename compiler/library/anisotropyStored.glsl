// needs:
// Rotates the slot anisotropy, a (cos 2t, sin 2t), into the frame that the unit normal n alone
// defines, so a reader needs only n. `own` measures t from du toward dv; the result measures t from
// T toward B. With w = 1 / (1 + n.z)
//   T = (1 - w n.x n.x, -w n.x n.y, -n.x)
//   B = (-w n.x n.y, 1 - w n.y n.y, -n.y)
// are orthonormal to n and continuous except at (0, 0, -1), where T is (1, 0, 0). With p = (du.T,
// du.B) the double angle is added by the complex product with p^2 / |p|^2. A left-handed (du, dv)
// about n reverses t. A zero du, or one parallel to n, adds angle 0. Error 1e-6 while du is at
// least 0.05 from n, and n from (0, 0, -1).
//   n = (0, 0, 1), du = (0, 2, 0), dv = (-1, 0, 0), own = (.5, 0):
//   p = (0, 1), p^2 = (-1, 0), result (-.5, 0)
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
