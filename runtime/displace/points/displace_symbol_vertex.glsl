// Precedes the geometry program of points: the points of a patch in rows, row i having i + 1
// points; or, with displace_spread, the three corners of each triangle moved toward its center, so
// that points that would coincide spread out.
uniform int displace_first; // index of the draw's first point in displace_drawn
uniform int displace_parts;
uniform float displace_spread; // share of the way to the center; 0: each grid point once
flat out uint displace_patchOf;
out vec3 displace_weights;

ivec3 corner(int row, int i)
{
    return ivec3(displace_parts - row, row - i, i);
}

// Returns the weights of a vertex. Row i has 2 i + 1 triangles, which alternately point to the
// previous row and to the next.
vec3 spread(int vertex)
{
    int triangle = vertex / 3, row = int(sqrt(float(triangle)));
    row += int((row + 1) * (row + 1) <= triangle) - int(row * row > triangle);
    int i = triangle - row * row, at = i / 2;
    ivec3 w[3] = i % 2 == 0 ? ivec3[3](corner(row, at), corner(row + 1, at),
        corner(row + 1, at + 1))
                            : ivec3[3](corner(row, at), corner(row + 1, at + 1),
                                corner(row, at + 1));
    return mix(vec3(w[vertex % 3]), vec3(w[0] + w[1] + w[2]) / 3.0, displace_spread);
}

void main()
{
    displace_patchOf = displace_drawn[displace_first + gl_InstanceID].x;
    displace_weights = (displace_spread > 0.0 ? spread(gl_VertexID)
        : vec3(displaceRow(gl_VertexID, displace_parts))) / float(displace_parts);
}
