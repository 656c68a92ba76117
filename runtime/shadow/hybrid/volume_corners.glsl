// The path `copy`, perfect triangulation: writes a texel for each corner of each quad, 2 x 2. The
// corners of a turned quad are rotated by one, as in the thesis, and marked by the sign of the
// depth: depths are not negative, and 0 has a sign, too.
uniform sampler2DArray volume_depths;
uniform float volume_layer;
out float corner_depth;

void main()
{
    const ivec2 corners[4] = ivec2[](ivec2(0, 0), ivec2(1, 0), ivec2(1, 1), ivec2(0, 1));
    ivec2 texel = ivec2(gl_FragCoord.xy), first = texel / 2, within = texel % 2;
    vec4 depths;
    for (int i = 0; i < 4; i++)
        depths[i] = texelFetch(volume_depths, ivec3(first + corners[i], int(volume_layer)), 0).x;
    int corner = within.y == 0 ? within.x : 3 - within.x;
    uint turned = uint(volumeTurned(depths));
    corner_depth =
        uintBitsToFloat(floatBitsToUint(depths[(corner + int(turned)) % 4]) | turned << 31);
}
