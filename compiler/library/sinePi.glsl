// needs:
// sin(pi x) for x in [0, 1]. Error of sin().
float sinePi(float x) {
    return sin(3.14159265 * x);
}
