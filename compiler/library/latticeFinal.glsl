// needs:
// A bijective finaliser, two rounds of shift and multiply, so that the top bits of every shift of the hash are good.
uvec4 latticeFinal(uvec4 h) {
    h = (h ^ (h >> 16u)) * 0x7FEB352Du;
    h = (h ^ (h >> 15u)) * 0x846CA68Bu;
    return h ^ (h >> 16u);
}
