// needs:
// cos(pi x) for x in [0, 1]. Error of cos().
float cosinePi(float x) {
    return cos(3.14159265 * x);
}
