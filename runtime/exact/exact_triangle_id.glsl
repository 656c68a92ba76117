// End of a surface's program for exact shadows: writes the triangle id, counted from 1 over all
// objects, in addition to the G-buffer.
layout(location = SEEN_TARGET) out uint exact_triangle_id;
layout(std430, binding = 5) readonly buffer ExactFirsts {
    uint exact_firsts[]; // number of each object's first triangle, in drawing order
};
#ifdef SEEN_INSTANCES
flat in uint seen_place;
#else
uniform int seen_place;
#endif

void main()
{
    surfaceMain();
    exact_triangle_id = exact_firsts[seen_place] + uint(gl_PrimitiveID);
}
