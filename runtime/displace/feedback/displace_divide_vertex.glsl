// Before the geometry program of feedback: a vertex as it stands in the buffer.
layout(location = 0) in uvec2 state; // the patch, and FINAL or LOWER
layout(location = 1) in vec2 weights;
flat out uvec2 divide_state;
out vec2 divide_weights;

void main()
{
    divide_state = state;
    divide_weights = weights;
}
