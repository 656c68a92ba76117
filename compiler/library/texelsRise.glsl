// needs:
// How the mix of four texels rises from one to the next along u and along v: of three rows of three, the lowest first; the last
// texel of the top row has no part in it. Differences come before the mix, so that nothing cancels.
vec2 texelsRise(vec3 row, vec3 above, vec3 top, vec2 weight) {
    vec2 low = mix(vec2(row.y - row.x, above.x - row.x), vec2(row.z - row.y, top.x - above.x), weight);
    vec2 high = mix(vec2(above.y - above.x, above.y - row.y), vec2(above.z - above.y, top.y - above.y), weight);
    return mix(low, high, weight.yx);
}
