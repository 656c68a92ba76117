// Which triangle a pixel sees: its number, counted from 1.
layout(location = 0) out uint exact_number;
void main() { exact_number = uint(gl_PrimitiveID) + 1u; }
