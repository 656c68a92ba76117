// needs: worleySearch
// Gradient by p (xyz; 0 for style 1) and value (w) of worley. Error 1e-6 over the distance.
vec4 worleyGradient(vec3 p, float jitter, int style, int dimensions) {
    vec3 away, nearest;
    worleySearch(p, jitter, dimensions, away, nearest);
    float far = length(away);
    return style > 0 ? vec4(0.0, 0.0, 0.0, jenkins(nearest, dimensions)) : vec4(away / max(far, 1.0e-6), far);
}
