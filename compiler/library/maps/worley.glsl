// needs: worleySearch
// Distance to the nearest of points at random, or, with `style` 1, the number of its cell, as MaterialX's worleynoise3d and worleynoise2d have it. Error 1e-6.
float worley(vec3 p, float jitter, int style, int dimensions) {
    vec3 away, nearest;
    worleySearch(p, jitter, dimensions, away, nearest);
    return style > 0 ? jenkins(nearest, dimensions) : length(away);
}
