// needs:
// Gradients at a simplex' corners, times 2^31, from their hashes: the top bits of three products, each of which depends on every bit
// of the hash; read as signed.
void simplexNumbers(uvec4 hash, out vec4 x, out vec4 y, out vec4 z) {
    x = vec4(ivec4(hash * 0xC2B2AE3Du));
    y = vec4(ivec4(hash * 0x27D4EB2Fu));
    z = vec4(ivec4(hash * 0x165667B1u));
}
