// The pass tone: linear light becomes an sRGB colour; with TONE_LIGHT it stays light. Where an edge
// runs through a pixel, what lies on both sides is mapped first, and blended then: a screen's light
// is summed by the eye, and an edge beside a lamp stays smooth. So are a pixel's samples, of which
// there are TONE_SAMPLES across and down. Before it stand tone.glsl, backdrop.glsl where there is
// one, and what declares edgeShare.
uniform sampler2D tone_light;
#ifdef TONE_TOOLS
uniform sampler2D tone_tools;
#endif

// IEC 61966-2-1
vec3 toneEncoded(vec3 c)
{
    return mix(12.92 * c, 1.055 * pow(max(c, 1e-6), vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}

// Display value, or the light itself; linear.
vec4 toneAt(ivec2 place)
{
    vec4 light = texelFetch(tone_light, place, 0);
#ifndef TONE_LIGHT
#ifdef BACKDROP
    if (light.w <= 0.0) return vec4(backdropAt(place), 1.0); // nothing is there
#endif
    light = vec4(clamp(toneMapped(toneGuard(light.xyz)), 0.0, 1.0), 1.0);
#ifdef TONE_TOOLS
    light.xyz = min(light.xyz + texelFetch(tone_tools, place, 0).xyz, 1.0);
#endif
#endif
    return light;
}

vec4 toneBlended(ivec2 place)
{
    ivec2 beyond;
    vec4 c = toneAt(place);
    float share = edgeShare(place, beyond);
#ifdef TONE_TOOLS
    if (texelFetch(tone_tools, place, 0).xyz != vec3(0.0)) share = 0.0; // a line stays whole
#endif
    return share > 0.0 ? mix(c, toneAt(beyond), share) : c;
}

// The mean of the pixel's samples.
vec4 passPixel(ivec2 pixel)
{
    vec4 c = toneBlended(pixel * TONE_SAMPLES);
    for (int i = 1; i < TONE_SAMPLES * TONE_SAMPLES; i++)
        c += toneBlended(pixel * TONE_SAMPLES + ivec2(i % TONE_SAMPLES, i / TONE_SAMPLES));
    c /= float(TONE_SAMPLES * TONE_SAMPLES);
#ifndef TONE_LIGHT
    c.xyz = toneEncoded(c.xyz);
#endif
    return c;
}
