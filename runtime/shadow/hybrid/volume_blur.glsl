// Depth blurring: mean of a texel and of eight bilinear samples at a distance of 1.5 texels. So of
// 36 weights the texel has 4, its neighbors along an axis 2, and all others in the 5 x 5 square 1.
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
