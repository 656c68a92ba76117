// needs: latticeResidue
// Value plus gradient terms of a face's four corners, times 380.5; d is the offset from the first
// corner. The numbers are affine functions of a hash in [0, 761), symmetric about 0.
vec4 latticeTerms(vec4 hash, vec3 d) {
    vec4 dx = vec4(d.x, d.x - 1.0, d.x, d.x - 1.0);
    vec4 dy = vec4(d.yy, d.yy - 1.0);
    return 0.5 * (hash - 380.0)
         + (latticeResidue(hash * 209.0 + 97.0) - 380.0) * dx
         + (latticeResidue(hash * 304.0 + 211.0) - 380.0) * dy
         + (latticeResidue(hash * 373.0 + 523.0) - 380.0) * d.z;
}
