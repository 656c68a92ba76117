// Depth blurring: the mean of a texel and of eight samples around it, 1.5 texels away, each linear
// between texels. So the texel counts 4 times, those beside it on an axis twice, all others of 5 x
// 5 once, of 36.
uniform sampler2D blur_depths;

void main()
{
    ivec2 texel = ivec2(gl_FragCoord.xy), last = textureSize(blur_depths, 0) - 1;
    float sum = 0.0;
    for (int y = -2; y <= 2; y++)
        for (int x = -2; x <= 2; x++)
            sum += float((x == 0 ? 2 : 1) * (y == 0 ? 2 : 1)) *
                   texelFetch(blur_depths, clamp(texel + ivec2(x, y), ivec2(0), last), 0).x;
    gl_FragDepth = sum / 36.0;
}
