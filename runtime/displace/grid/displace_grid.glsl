// Vertex program of a grid: vertices are the points of a patch in rows, ordered as in scene_divide;
// instances are patches.
uniform int displace_first; // index of the draw's first patch in displace_drawn
uniform int displace_parts; // number of parts of an edge of the grid

void main()
{
    uvec2 drawn = displace_drawn[displace_first + gl_InstanceID];
    ivec3 w = displaceFitted(displaceRow(gl_VertexID, displace_parts), drawn.y, displace_parts);
    displacePoint(drawn.x, vec3(w) / float(displace_parts));
}
