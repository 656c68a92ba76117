// needs: worleySearch
// Distance to the nearest random point or, for style 1, its cell's number, as MaterialX's
// worleynoise3d and worleynoise2d. Error 1e-6.
float worley(vec3 p, float jitter, int style, int dimensions) {
    vec3 away, nearest;
    worleySearch(p, jitter, dimensions, away, nearest);
    return style > 0 ? jenkins(nearest, dimensions) : length(away);
}
