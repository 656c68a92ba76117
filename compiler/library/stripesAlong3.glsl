// needs: stripesNear3
// Mean of the product of the components' stripes over four adjacent boxes along a direction; q in
// [0, 1]. Components with edge < 1/1024 are evaluated once. Error 1e-4 near that edge, else 1e-6.
float stripesAlong3(vec3 q, vec3 along, vec3 edges) {
    vec3 narrow = step(edges, vec3(1.0 / 1024.0));
    vec3 near = stripesNear3(q, min(edges, 1.0 / 1024.0));
    vec3 width = max(edges, 1.0 / 1024.0);
    vec3 inverse = 1.0 / width;
    float sum = 0.0;
    for (float at = -0.375; at < 0.5; at += 0.25) {
        vec3 x = q + at * along;
        vec3 s = (abs(fract(x - 0.5 * width) - 0.5) - abs(fract(x + 0.5 * width) - 0.5)) * inverse;
        s = mix(s, near, narrow);
        sum += s.x * s.y * s.z;
    }
    return 0.25 * sum;
}
