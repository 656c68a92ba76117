// needs:
// Spheremap encoding of a unit normal in [0, 1]^2: n.xy / sqrt(8 n.z + 8) + 1/2. For n.z < 0 the
// equal form normalize(n.xy) sqrt((1 - n.z) / 8) + 1/2 stays accurate near -z. (0, 0, -1) itself
// uses the direction +x.
vec2 encodeSpheremap(vec3 n) {
    float square = dot(n.xy, n.xy);
    vec2 direction = square > 1.0e-30 ? n.xy * inversesqrt(max(square, 1.0e-30)) : vec2(1.0, 0.0);
    vec2 front = n.xy * inversesqrt(8.0 * max(n.z, 0.0) + 8.0);
    vec2 back = direction * sqrt(0.125 - 0.125 * min(n.z, 0.0));
    return clamp((n.z < 0.0 ? back : front) + 0.5, 0.0, 1.0);
}
