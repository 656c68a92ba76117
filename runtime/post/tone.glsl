// Tone curves: map linear light to linear display values by the formulas of scene.def. One of
// TONE_Clamp ... is defined. Values of the whole picture are in three texels:
//   0  the greatest red, green, blue and luminance
//   1  the sums of red, green, blue and luminance
//   2  of pixels whose luminance is above LEAST: the sum of ln(luminance), their count, the least
//      luminance
layout(std140) uniform Tone {
    float tone_exposure;
    float tone_pixels; // number of measured pixels
    vec4 tone_numbers;
};

const float LEAST = 1e-8, GREATEST = 1e18;

float toneLuminance(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }

float toneGreatest(vec3 c) { return max(max(c.x, c.y), c.z); }

// NaN and negative values become black; infinity is clamped to GREATEST.
vec3 toneGuard(vec3 c) { return mix(vec3(0.0), min(c, GREATEST), greaterThan(c, vec3(0.0))); }

#ifdef TONE_MEASURES
uniform sampler2D tone_measured;

vec4 toneMeasured(int i) { return texelFetch(tone_measured, ivec2(i, 0), 0); }

// Returns the mean logarithm of the luminances.
float toneMeanLogarithm()
{
    vec4 dark = toneMeasured(2);
    return dark.y > 0.0 ? dark.x / dark.y : 0.0;
}
#endif

#ifdef TONE_Clamp
vec3 toneMapped(vec3 c) { return c * tone_exposure; }
#endif

#ifdef TONE_Filmic
vec3 toneMapped(vec3 c)
{
    vec3 x = min(c * tone_exposure, 1e6);
    return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
}
#endif

#ifdef TONE_Shoulder
vec3 toneMapped(vec3 c)
{
    float knee = tone_numbers.x;
    vec3 x = min(c * tone_exposure, 1e6), over = max(x - knee, 0.0) / (1.0 - knee);
    return min(x, knee) + (1.0 - knee) * over / (1.0 + over);
}
#endif

#ifdef TONE_Exponential
vec3 toneMapped(vec3 c)
{
    vec3 x = min(c * tone_exposure, 1e6);
    float greatest = max(toneGreatest(x), 1e-6);
    return x * ((1.0 - exp(-greatest)) / greatest);
}
#endif

#ifdef TONE_Linear
vec3 toneMapped(vec3 c)
{
    float greatest = toneGreatest(toneMeasured(0).xyz);
    return greatest > 0.0 ? c / greatest * tone_exposure : vec3(0.0);
}
#endif

#ifdef TONE_ReinhardDevlin
uniform sampler2D tone_adapted; // texels 0 and 2 of the reduction of toneAdapted() over all pixels

float toneContrast()
{
    float brightest = log(max(toneMeasured(0).w, LEAST)),
        darkest = log(max(toneMeasured(2).z, LEAST));
    float key = brightest > darkest ? (brightest - toneMeanLogarithm()) / (brightest - darkest)
        : 1.0;
    return tone_numbers.y > 0.0 ? tone_numbers.y : 0.3 + 0.7 * pow(clamp(key, 0.0, 1.0), 1.4);
}

vec3 toneAdapted(vec3 c)
{
    vec4 mean = toneMeasured(1) / tone_pixels;
    vec3 here = mix(vec3(toneLuminance(c)), c, tone_numbers.z);
    vec3 adaptation = mix(mix(vec3(mean.w), mean.xyz, tone_numbers.z), here, tone_numbers.w);
    vec3 half_ = pow(max(exp(-tone_numbers.x) * adaptation, 1e-30), vec3(toneContrast()));
    return c / (c + max(half_, 1e-30));
}

vec3 toneMapped(vec3 c)
{
    float greatest = toneGreatest(texelFetch(tone_adapted, ivec2(0, 0), 0).xyz);
    float least = texelFetch(tone_adapted, ivec2(2, 0), 0).w;
    vec3 adapted = toneAdapted(c);
    return greatest > least ? (adapted - least) / (greatest - least) : adapted;
}
#endif

#ifdef TONE_Drago
vec3 toneMapped(vec3 c)
{
    float luminance = toneLuminance(c);
    float scale = tone_exposure / exp(toneMeanLogarithm());
    float x = luminance * scale, greatest = toneMeasured(0).w * scale;
    if (luminance <= LEAST || greatest <= 0.0) return vec3(0.0);
    float curve = pow(min(x / greatest, 1.0), log(tone_numbers.x) / log(0.5));
    float shown = log(1.0 + x) / log(2.0 + 8.0 * curve) * log(10.0) / log(1.0 + greatest);
    return c * (shown / luminance);
}
#endif
