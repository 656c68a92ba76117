// Before the geometry program of points: those of a patch in rows, row i of which has i + 1; or
// three for each of its triangles, on their way from the corners to the middle, so that points that
// would stand in one place fill the gaps around it.
uniform int displace_first; // of displace_drawn
uniform int displace_parts;
uniform float displace_spread; // so much of that way; 0: the corners once
flat out uint displace_patchOf;
out vec3 displace_weights;

ivec3 corner(int row, int i)
{
    return ivec3(displace_parts - row, row - i, i);
}

// Row i has 2 i + 1 triangles: one that points to the row before, one to the next, and so on.
vec3 spread(int vertex)
{
    int triangle = vertex / 3, row = int(sqrt(float(triangle)));
    row += int((row + 1) * (row + 1) <= triangle) - int(row * row > triangle);
    int i = triangle - row * row, at = i / 2;
    ivec3 w[3] = i % 2 == 0 ? ivec3[3](corner(row, at), corner(row + 1, at), corner(row + 1, at + 1))
                            : ivec3[3](corner(row, at), corner(row + 1, at + 1), corner(row, at + 1));
    return mix(vec3(w[vertex % 3]), vec3(w[0] + w[1] + w[2]) / 3.0, displace_spread);
}

void main()
{
    displace_patchOf = displace_drawn[displace_first + gl_InstanceID].x;
    displace_weights = (displace_spread > 0.0 ? spread(gl_VertexID) : vec3(displaceRow(gl_VertexID, displace_parts))) / float(displace_parts);
}
