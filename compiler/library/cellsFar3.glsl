// needs:
// How far away a point is: 0 by the square of its euclidean distance, 1 by the sum, 2 by the greatest of its coordinates.
float cellsFar3(vec3 away, int metric) {
    vec3 a = abs(away);
    return metric == 0 ? dot(away, away) : metric == 1 ? a.x + a.y + a.z : max(a.x, max(a.y, a.z));
}
