// The end of a surface's program where shadows are exact: the number of the triangle that is drawn,
// counted from 1 over all objects, beside the G-buffer.
layout(location = SEEN_TARGET) out uint exact_number;
layout(std430, binding = 5) readonly buffer ExactFirsts {
    uint exact_firsts[]; // of objects, in the order of drawing: the number of the first triangle
};
#ifdef SEEN_INSTANCES
flat in uint seen_place;
#else
uniform int seen_place;
#endif

void main()
{
    surfaceMain();
    exact_number = exact_firsts[seen_place] + uint(gl_PrimitiveID);
}
