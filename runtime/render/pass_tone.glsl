// The pass tone: linear light becomes an sRGB colour, by the formulas of scene.def.
layout(std140) uniform Tone {
    float tone_exposure;
    int tone_filmic;
};
uniform sampler2D tone_light;

vec3 toneFilmic(vec3 x)
{
    return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
}

// IEC 61966-2-1
vec3 toneEncoded(vec3 c)
{
    return mix(12.92 * c, 1.055 * pow(max(c, 1e-6), vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}

vec4 passPixel(ivec2 pixel)
{
    vec3 c = max(texelFetch(tone_light, pixel, 0).xyz * tone_exposure, 0.0);
    if (tone_filmic != 0) c = toneFilmic(min(c, 1e6));
    return vec4(toneEncoded(min(c, 1.0)), 1.0);
}
