// needs:
// Differences along u and v of bilinear interpolation, from three rows of three texels, bottom row
// first; top.z is unused. Differences are taken before mixing, which avoids cancellation.
vec2 texelsRise(vec3 row, vec3 above, vec3 top, vec2 weight) {
    vec2 low = mix(vec2(row.y - row.x, above.x - row.x), vec2(row.z - row.y, top.x - above.x), weight);
    vec2 high = mix(vec2(above.y - above.x, above.y - row.y), vec2(above.z - above.y, top.y - above.y), weight);
    return mix(low, high, weight.yx);
}
