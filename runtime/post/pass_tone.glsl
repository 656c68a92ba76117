// The tone pass: maps linear light to sRGB colors; with TONE_LIGHT the light stays linear. At an
// edge the colors of both sides are tone-mapped before they are blended, so that an edge next to a
// bright lamp stays smooth: the eye averages displayed light. The pixel's TONE_SAMPLES x
// TONE_SAMPLES samples are averaged after tone mapping, too. Concatenated after tone.glsl,
// backdrop.glsl if used, and the text that declares edgeShare.
uniform sampler2D tone_light;
#ifdef TONE_TOOLS
uniform sampler2D tone_tools;
#endif

// sRGB transfer function (IEC 61966-2-1).
vec3 toneEncoded(vec3 c)
{
    return mix(12.92 * c, 1.055 * pow(max(c, 1e-6), vec3(1.0 / 2.4)) - 0.055,
        greaterThan(c, vec3(0.0031308)));
}

// Returns the tone-mapped color, or with TONE_LIGHT the light; both linear.
vec4 toneAt(ivec2 place)
{
    vec4 light = texelFetch(tone_light, place, 0);
#ifndef TONE_LIGHT
#ifdef BACKDROP
    if (light.w <= 0.0) return vec4(backdropAt(place), 1.0); // the pixel shows the background
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
    // tool lines are not blended
    if (texelFetch(tone_tools, place, 0).xyz != vec3(0.0)) share = 0.0;
#endif
    return share > 0.0 ? mix(c, toneAt(beyond), share) : c;
}

// Returns the mean of the pixel's samples.
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
