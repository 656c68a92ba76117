// needs:
// Bijective hash finalizer, two xorshift-multiply rounds: the top bits of every shifted hash are
// well mixed.
uvec4 latticeFinal(uvec4 h) {
    h = (h ^ (h >> 16u)) * 0x7FEB352Du;
    h = (h ^ (h >> 15u)) * 0x846CA68Bu;
    return h ^ (h >> 16u);
}
