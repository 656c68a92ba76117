// needs:
// Values and gradients of a face's four corners, times 2^31: the hash shifted left by 0, 7, 14, 21,
// read as signed.
void latticeNumbers(uvec4 hash, out vec4 value, out vec4 x, out vec4 y, out vec4 z) {
    value = vec4(ivec4(hash));
    x = vec4(ivec4(hash << 7u));
    y = vec4(ivec4(hash << 14u));
    z = vec4(ivec4(hash << 21u));
}
