// Before patches are tessellated: a corner knows which of those that are drawn it is of.
flat out int displace_corner;

void main()
{
    displace_corner = gl_VertexID / 3;
}
