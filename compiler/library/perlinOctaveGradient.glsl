// needs: perlinDirection
// Gradient by p (xyz) and value (w) of perlinOctave. Error 4e-6.
vec4 perlinOctaveGradient(vec3 p, int dimensions) {
    vec3 q = clamp(p, -16777216.0, 16777216.0) * vec3(1.0, 1.0, dimensions < 3 ? 0.0 : 1.0);
    vec3 cell = floor(q);
    vec3 d = q - cell;
    vec3 far = d * d * d * (d * (d * 6.0 - 15.0) + 10.0);
    vec3 rate = 30.0 * d * d * (1.0 - d) * (1.0 - d);
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 8; i++) {
        if (i > 3 && dimensions < 3) break;
        vec3 corner = vec3(i == 1 || i == 3 || i == 5 || i == 7, i == 2 || i == 3 || i > 5, i > 3);
        vec3 share = mix(1.0 - far, far, corner);
        vec3 change = rate * (2.0 * corner - 1.0);
        vec3 direction = perlinDirection(cell + corner, dimensions);
        float value = dot(direction, d - corner);
        sum += vec4(share.x * share.y * share.z * direction + value * change * share.yzx * share.zxy, share.x * share.y * share.z * value);
    }
    return sum;
}
