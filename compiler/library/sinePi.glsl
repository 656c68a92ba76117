// needs:
// Sine of pi x for x in [0, 1]. As accurate as the sine.
float sinePi(float x) {
    return sin(3.14159265 * x);
}
