// needs:
// The distance that cellsFar2 and cellsFar3 compare by.
float cellsDistance(float far, int metric) {
    return metric == 0 ? sqrt(far) : far;
}
