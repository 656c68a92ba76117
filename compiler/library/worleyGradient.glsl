// needs: worleySearch
// Gradient by p of worley, then its value; 0 of numbers of cells. Error 1e-6 over the distance.
vec4 worleyGradient(vec3 p, float jitter, int style, int dimensions) {
    vec3 away, nearest;
    worleySearch(p, jitter, dimensions, away, nearest);
    float far = length(away);
    return style > 0 ? vec4(0.0, 0.0, 0.0, jenkins(nearest, dimensions)) : vec4(away / max(far, 1.0e-6), far);
}
