// Tessellation evaluation: displaces a point that the tessellator generates.
layout(triangles, equal_spacing, ccw) in;
patch in int displace_number;

void main()
{
    displacePoint(displace_drawn[displace_number].x, gl_TessCoord);
}
