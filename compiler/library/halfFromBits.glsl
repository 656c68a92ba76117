// needs:
// Inverse of halfBits: exact for every finite half float.
float halfFromBits(uint code) {
    uint size = code & 0x7FFFu;
    float normal = uintBitsToFloat((size << 13) + 0x38000000u);
    float value = size < 0x400u ? float(size) * (1.0 / 16777216.0) : normal;
    return code >= 0x8000u ? -value : value;
}
