// Precedes the geometry program of feedback: passes on a vertex of the buffer.
layout(location = 0) in uvec2 state; // the patch, and flags FINAL or LOWER
layout(location = 1) in vec2 weights;
flat out uvec2 divide_state;
out vec2 divide_weights;

void main()
{
    divide_state = state;
    divide_weights = weights;
}
