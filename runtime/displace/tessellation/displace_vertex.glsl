// Precedes tessellation: passes on the number of the drawn patch to which the corner belongs.
flat out int displace_corner;

void main()
{
    displace_corner = gl_VertexID / 3;
}
