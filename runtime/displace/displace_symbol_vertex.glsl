// Before the geometry program of points: those of a patch in rows, row i of which has i + 1.
uniform int displace_first; // of displace_drawn
uniform int displace_parts;
flat out uint displace_patchOf;
out vec3 displace_weights;

void main()
{
    displace_patchOf = displace_drawn[displace_first + gl_InstanceID].x;
    displace_weights = vec3(displaceRow(gl_VertexID, displace_parts)) / float(displace_parts);
}
