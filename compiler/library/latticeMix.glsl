// needs:
// Mixes eight corner terms with weights 3d^2 - 2d^3. Order: (x, y) = (0,0) (1,0) (0,1) (1,1), z = 0
// in `low` and 1 in `high`.
float latticeMix(vec4 low, vec4 high, vec3 d) {
    vec3 s = d * d * (3.0 - 2.0 * d);
    vec4 plane = mix(low, high, s.z);
    vec2 line = mix(plane.xy, plane.zw, s.y);
    return mix(line.x, line.y, s.x);
}
