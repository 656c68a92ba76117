// Where no pass looks for edges.
float edgeShare(ivec2 pixel, out ivec2 beyond)
{
    beyond = pixel;
    return 0.0;
}
