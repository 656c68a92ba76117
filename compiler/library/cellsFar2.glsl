// needs:
// Distance of an offset, for comparison. Metric 0: Euclidean, squared; 1: Manhattan; 2: Chebyshev.
float cellsFar2(vec2 away, int metric) {
    vec2 a = abs(away);
    return metric == 0 ? dot(away, away) : metric == 1 ? a.x + a.y : max(a.x, a.y);
}
