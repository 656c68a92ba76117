// Before a geometry program: what it is given is a number.
flat out int displace_item;

void main()
{
    displace_item = gl_VertexID;
}
