// needs:
// Cosine of pi x for x in [0, 1]. As accurate as the cosine.
float cosinePi(float x) {
    return cos(3.14159265 * x);
}
