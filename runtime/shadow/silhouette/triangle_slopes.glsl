// End of a surface's program for silhouette shadows: writes the depth slopes of the drawn triangle,
// in addition to the G-buffer. An interpolated normal may face the light although the triangle
// faces away. Slopes are differences of depth from pixel to pixel, divided by depth: half floats.
layout(location = SEEN_TARGET) out uint triangle_slopes;

void main()
{
    // computes derivatives before any discard
    vec2 slope = vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z)) / gl_FragCoord.z;
    surfaceMain();
    // sets the lowest bit, since 0 marks pixels where nothing is drawn
    triangle_slopes = packHalf2x16(clamp(slope * 4096.0, -65504.0, 65504.0)) | 1u;
}
