// needs:
// Distance of an offset, for comparison. Metric 0: Euclidean, squared; 1: Manhattan; 2: Chebyshev.
float cellsFar3(vec3 away, int metric) {
    vec3 a = abs(away);
    return metric == 0 ? dot(away, away) : metric == 1 ? a.x + a.y + a.z : max(a.x, max(a.y, a.z));
}
