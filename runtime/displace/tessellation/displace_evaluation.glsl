// A point that the tessellator makes.
layout(triangles, equal_spacing, ccw) in;
patch in int displace_number;

void main()
{
    displacePoint(displace_drawn[displace_number].x, gl_TessCoord);
}
