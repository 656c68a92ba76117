// The second program of feedback: displaces the vertices of the divided triangles.
layout(location = 0) in uvec2 state;
layout(location = 1) in vec2 weights;

void main()
{
    displaceAt(state.x, vec3(weights, 1.0 - weights.x - weights.y), (state.y & 2u) != 0u);
}
