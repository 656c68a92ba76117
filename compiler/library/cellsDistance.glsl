// needs:
// Converts the result of cellsFar2 or cellsFar3 to a distance.
float cellsDistance(float far, int metric) {
    return metric == 0 ? sqrt(far) : far;
}
