// The pass tone: linear light becomes an sRGB colour. Before it stands tone.glsl.
uniform sampler2D tone_light;

// IEC 61966-2-1
vec3 toneEncoded(vec3 c)
{
    return mix(12.92 * c, 1.055 * pow(max(c, 1e-6), vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}

vec4 passPixel(ivec2 pixel)
{
    vec4 light = texelFetch(tone_light, pixel, 0);
    vec3 shown = toneEncoded(clamp(toneMapped(toneGuard(light.xyz)), 0.0, 1.0));
    ivec2 tile = pixel + ivec2(tone_x, tone_y) >> 4;
    if (tone_tiles != 0 && light.w <= 0.0) shown = vec3((tile.x + tile.y & 1) != 0 ? 0.4 : 0.6); // nothing is there
    return vec4(shown, 1.0);
}
