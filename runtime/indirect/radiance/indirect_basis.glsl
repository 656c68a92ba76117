// Completes a unit vector to an orthonormal basis (Duff et al. 2017).
void indirectBasis(vec3 n, out vec3 u, out vec3 v)
{
    float side = n.z < 0.0 ? -1.0 : 1.0, a = -1.0 / (side + n.z), b = n.x * n.y * a;
    u = vec3(1.0 + side * n.x * n.x * a, side * b, -side * n.x);
    v = vec3(b, side + n.y * n.y * a, -n.y);
}
