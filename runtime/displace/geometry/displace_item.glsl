// Precedes a geometry program: passes on the vertex number.
flat out int displace_item;

void main()
{
    displace_item = gl_VertexID;
}
