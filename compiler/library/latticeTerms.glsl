// needs:
// Value plus gradient terms of a face's four corners, times 2^31; d is the offset from the first
// corner. The numbers are the hash shifted left by 0, 7, 14, 21, read as signed: uniform, symmetric
// to 2^-11.
vec4 latticeTerms(uvec4 hash, vec3 d) {
    vec4 dx = vec4(d.x, d.x - 1.0, d.x, d.x - 1.0);
    vec4 dy = vec4(d.yy, d.yy - 1.0);
    return 0.5 * vec4(ivec4(hash)) + vec4(ivec4(hash << 7u)) * dx + vec4(ivec4(hash << 14u)) * dy
         + vec4(ivec4(hash << 21u)) * d.z;
}
