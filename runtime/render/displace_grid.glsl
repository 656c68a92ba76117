// The vertex program of a grid: vertex by vertex the points of a patch in rows, as scene_divide has them, patch by patch as instances. Those of an edge that has fewer parts
// go back to the last point that there is, so that triangles beside it have no width and its neighbour's points stand in the same places.
uniform int displace_first; // of displace_drawn
uniform int displace_parts; // of an edge of the grid

void main()
{
    uvec2 drawn = displace_drawn[displace_first + gl_InstanceID];
    int row = int((sqrt(float(8 * gl_VertexID + 1)) - 1.0) / 2.0);
    row += int((row + 1) * (row + 2) / 2 <= gl_VertexID) - int(row * (row + 1) / 2 > gl_VertexID);
    int i = gl_VertexID - row * (row + 1) / 2;
    ivec3 w = ivec3(displace_parts - row, row - i, i);
    for (int k = 0; k < 3; k++)
        if (w[k] == 0) {
            int parts = int(displaceParts(drawn.y)[k]);
            int at = w[(k + 1) % 3] * parts / displace_parts * displace_parts / parts;
            w[(k + 1) % 3] = at;
            w[(k + 2) % 3] = displace_parts - at;
        }
    displacePoint(drawn.x, vec3(w) / float(displace_parts));
}
