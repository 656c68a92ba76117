// needs: jenkins
// Finds the nearest cell point in the 3 x 3 (x 3) neighborhood of p: `away` is p minus the point,
// `nearest` its cell. Each cell has one random point; `jitter` scales its offset from the center.
// Coordinates are clamped to 2^24; in 2D z is 0. Error 3e-7.
void worleySearch(vec3 p, float jitter, int dimensions, out vec3 away, out vec3 nearest) {
    vec3 axes = vec3(1.0, 1.0, dimensions < 3 ? 0.0 : 1.0);
    vec3 q = clamp(p, -16777216.0, 16777216.0) * axes;
    vec3 cell = floor(q);
    vec3 d = q - cell;
    float least = 1.0e6;
    away = vec3(0.0);
    nearest = cell;
    for (int i = 0; i < 27; i++) {
        if (i > 8 && dimensions < 3) break;
        float rows = floor((float(i) + 0.5) / 3.0);
        float plane = floor((float(i) + 0.5) / 9.0);
        vec3 beside = (vec3(float(i) - 3.0 * rows, rows - 3.0 * plane, plane) - 1.0) * axes;
        vec3 far = d - beside - ((jenkinsPlaces(cell + beside, dimensions) - 0.5) * jitter + 0.5) * axes;
        float square = dot(far, far);
        if (square < least) {
            least = square;
            away = far;
            nearest = cell + beside;
        }
    }
}
