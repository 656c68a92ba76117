// Decodes the edge pass's result: the share of a pixel on the far side of an edge, and the adjacent
// pixel on that side.
uniform usampler2D edge_words;

// Returns the area of the unit box around a pixel center on the far side of a line. The line has
// slope s in [-1, 1] and is `away` in [0, 1] from the center along the minor axis. If the line
// leaves through two adjacent sides, the area is a triangle.
float edgeArea(float away, float s)
{
    float most = 0.5 - away + 0.5 * s, least = 0.5 - away - 0.5 * s;
    return least >= 0.0 ? 0.5 - away : most > 0.0 ? 0.5 * most * most / s : 0.0;
}

float edgeShare(ivec2 pixel, out ivec2 beyond)
{
    uint word = texelFetch(edge_words, pixel, 0).x;
    ivec2 way = ivec2(int(word >> 1 & 3u) - 1, (word >> 20 & 1u) != 0u ? 1 : -1);
    beyond = pixel + ((word >> 19 & 1u) != 0u ? way.yx : way);
    if (word == 0u) return 0.0;
    float slope = float(word >> 8 & 2047u) / 1023.0 * 2.0 - 1.0;
    return edgeArea(1.0 - float(word >> 21 & 1023u) / 1023.0, abs(slope));
}
