// needs:
// e^v, v taken to at most 88.
float waveExp(float v) {
    return exp(min(v, 88.0));
}
