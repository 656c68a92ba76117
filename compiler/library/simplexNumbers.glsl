// needs:
// Gradients at a simplex' corners, times 2^31: three products of the hash, read as signed; their
// top bits depend on every bit.
void simplexNumbers(uvec4 hash, out vec4 x, out vec4 y, out vec4 z) {
    x = vec4(ivec4(hash * 0xCAF4BCE3u));
    y = vec4(ivec4(hash * 0xCF612DE7u));
    z = vec4(ivec4(hash * 0x6BA88D47u));
}
