// needs: perlinDirection
// Perlin's improved noise (2002) in 2D or 3D, with the hash of OSL and MaterialX and the fade 6t^5
// - 15t^4 + 10t^3. Coordinates are clamped to 2^24, where floats have no fraction and the noise is
// 0. Error 1e-6.
float perlinOctave(vec3 p, int dimensions) {
    vec3 q = clamp(p, -16777216.0, 16777216.0) * vec3(1.0, 1.0, dimensions < 3 ? 0.0 : 1.0);
    vec3 cell = floor(q);
    vec3 d = q - cell;
    vec3 far = d * d * d * (d * (d * 6.0 - 15.0) + 10.0);
    float sum = 0.0;
    for (int i = 0; i < 8; i++) {
        if (i > 3 && dimensions < 3) break;
        vec3 corner = vec3(i == 1 || i == 3 || i == 5 || i == 7, i == 2 || i == 3 || i > 5, i > 3);
        vec3 share = mix(1.0 - far, far, corner);
        sum += share.x * share.y * share.z * dot(perlinDirection(cell + corner, dimensions), d - corner);
    }
    return sum;
}
