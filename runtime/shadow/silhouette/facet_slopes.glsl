// The end of a surface's program where shadows are found by silhouettes: how steep the triangle is
// that is drawn, beside the G-buffer. A surface's normal is the mean of its corners', and may look
// to the light where the triangle looks away. Slopes are those of depth from pixel to pixel, over
// depth: halves.
layout(location = SEEN_TARGET) out uint facet_slopes;

void main()
{
    vec2 slope = vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z)) / gl_FragCoord.z; // before anything is discarded
    surfaceMain();
    facet_slopes = packHalf2x16(clamp(slope * 4096.0, -65504.0, 65504.0)) | 1u; // 0: nothing is drawn
}
