// Replaces edge_part.glsl if the edge pass does not run.
float edgeShare(ivec2 pixel, out ivec2 beyond)
{
    beyond = pixel;
    return 0.0;
}
