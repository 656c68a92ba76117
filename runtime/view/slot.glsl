// Shows one slot of the G-buffer instead of lighting it. It stands behind the text that declares Surface and unpackSurface, and
// behind SLOT_SHOWN, a vec3 made of the surface s in the lanes of the picture.
uniform sampler2D light_depth;
out vec4 light_color;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    light_color = vec4(vec3(.02), 1.);
    if (texelFetch(light_depth, pixel, 0).x >= 1.) return; // nothing was drawn here
    Surface s = unpackSurface(pixel);
    light_color.rgb = SLOT_SHOWN;
}
