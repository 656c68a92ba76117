// needs:
// How far away a point is: 0 by the square of its euclidean distance, 1 by the sum, 2 by the greatest of its coordinates.
float cellsFar2(vec2 away, int metric) {
    vec2 a = abs(away);
    return metric == 0 ? dot(away, away) : metric == 1 ? a.x + a.y : max(a.x, a.y);
}
