// Radiance that a surface sends to the eye, summed over all lights, in eye space: for every pass
// that lights surfaces. view_space.h describes the block and the texels. Preceded by the texts that
// declare Surface and the surface model.
#include "light.layout.def"

layout(std140) uniform Light {
    vec4 light_ray;
    vec4 light_view;
    int light_plain, light_points;
};

// LIGHT_BLOCK texels of all lights in a uniform block: all pixels read the same texel at a time,
// which is faster than from a texture.
#ifdef LIGHT_BLOCK
layout(std140) uniform Lights {
    vec4 light_texels[LIGHT_BLOCK];
};

vec4 lightNumbers(int texel) { return light_texels[texel]; }
#else
uniform sampler2D light_lights;

vec4 lightNumbers(int texel)
{
    return texelFetch(light_lights, ivec2(texel % LIGHT_ROW, texel / LIGHT_ROW), 0);
}
#endif

// A light's texel, LIGHT_PLACE and so on; plain lights have fewer texels and come first.
vec4 lightTexel(int light, int texel)
{
    int others = LIGHT_TEXELS * light - (LIGHT_TEXELS - LIGHT_PLAIN_TEXELS) * light_plain;
    return lightNumbers((light < light_plain ? LIGHT_PLAIN_TEXELS * light : others) + texel);
}

// Returns the irradiance at a point from a point light without shadows, and the direction l to it.
vec3 lightPlain(int light, vec3 point, out vec3 l)
{
    vec3 way = lightNumbers(LIGHT_PLAIN_TEXELS * light + LIGHT_PLACE).xyz - point;
    float over = inversesqrt(max(dot(way, way), 1e-30));
    l = way * over;
    return lightNumbers(LIGHT_PLAIN_TEXELS * light + LIGHT_POWER).xyz * (over * over);
}

// Returns the irradiance at a point from any other light.
vec3 lightAt(int light, vec3 point, out vec3 l)
{
    vec4 place = lightTexel(light, LIGHT_PLACE);
    vec2 cone = lightTexel(light, LIGHT_CONE).xy;
    vec3 way = place.xyz - place.w * point;
    float square = max(dot(way, way), 1e-30);
    l = way * inversesqrt(square);
    float s = clamp(cone.x * -dot(l, lightTexel(light, LIGHT_AXIS).xyz) + cone.y, 0.0, 1.0);
    return lightTexel(light, LIGHT_POWER).xyz *
        (s * s * (3.0 - 2.0 * s) / (place.w > 0.0 ? square : 1.0));
}

// Returns the radiance of a pixel without a surface.
vec4 lightOfNothing(ivec2 pixel)
{
#ifdef BACKDROP
    return vec4(backdrop_share * backdropAt(pixel), 0.0);
#else
    return vec4(0.0);
#endif
}

// A visible surface point.
struct Seen {
    ivec2 pixel;
    vec3 point;
    float pixelSize; // width of a pixel at the point, in eye-space units
    Lit m;
};

// Returns the unit direction to the eye, through a pixel.
vec3 lightToEye(ivec2 pixel)
{
    return light_view.y > 0.0 ? vec3(0.0, 0.0, 1.0)
        : normalize(vec3((light_ray.zw - vec2(2 * pixel + 1)) * light_ray.xy, 1.0));
}

// Returns the surface point of a pixel; depth > 0.
Seen lightSeen(ivec2 pixel, float depth, Surface surface)
{
    bool orthographic = light_view.y > 0.0;
    vec3 ray = vec3((vec2(2 * pixel + 1) - light_ray.zw) * light_ray.xy, -1.0);
    vec3 point = orthographic ? vec3(ray.xy, (depth - 1.0) * light_view.x)
        : ray * (light_view.x / depth);
#ifdef SHADOW_CALL_PIXEL
    shadowAtPixel(pixel, depth, point, light_ray, light_view);
#endif
    return Seen(pixel, point, 2.0 * light_ray.x * (orthographic ? 1.0 : -point.z),
        surfaceLit(surface, lightToEye(pixel)));
}

// With tiled shadow lists the pass runs several times, and results add up: light that reads no list
// is added in the first run.
bool lightIsFirst()
{
#ifdef SHADOW_PARTS
    return shadowIsFirst();
#else
    return true;
#endif
}

// Returns the transmittance of a pass over the light below it: later runs only add light.
vec3 lightOver(vec3 through)
{
    return lightIsFirst() ? through : vec3(1.0);
}

// Returns the reflected ambient light, unshadowed; a sum over kinds of lights, composed by
// light_sum.c.
vec3 lightAround(Seen seen);

// Adds the reflected light of kinds with GLSL and a position; composed, too.
vec3 lightFromKinds(vec3 sum, Seen seen);

// Emission and ambient light, plus light of kinds with GLSL. Ambient light that ambient occlusion
// dims is added later.
vec3 lightEven(Seen seen)
{
#ifdef LIGHT_AROUND_LATER
    vec3 sum = surfaceOwn(seen.m);
#else
    vec3 sum = surfaceOwn(seen.m) + lightAround(seen);
#endif
    return lightFromKinds(sum, seen);
}

vec3 lightFromPlain(int light, Seen seen)
{
    vec3 l;
    vec3 arrives = lightPlain(light, seen.point, l);
    return arrives * surfaceLobe(seen.m, l);
}

vec3 lightFromOther(int light, Seen seen)
{
    vec3 l;
    ivec2 views = ivec2(lightTexel(light, LIGHT_CONE).zw);
#ifdef SHADOW_PARTS
    if (!shadowIsRead(views)) return vec3(0.0);
#endif
    vec3 arrives = lightAt(light, seen.point, l);
    vec3 sent = arrives * surfaceLobe(seen.m, l);
#if defined SHADOW_MAPS || defined SHADOW_PLANES || defined SHADOW_SHEETS || \
    defined SHADOW_CALL_LIGHT
    if (sent.x + sent.y + sent.z <= 0.0) return sent;
    vec3 side = dot(seen.m.normal, l) < 0.0 ? -seen.m.normal : seen.m.normal;
#endif
#ifdef SHADOW_CALL_WAY
    shadowWay(seen.m.normal, l);
#endif
#ifdef SHADOW_APART
    shadow_apart = false;
#endif
#ifdef SHADOW_CALL_LIGHT
    int method = int(lightTexel(light, LIGHT_AXIS).w);
    sent *= shadowOfLight(method % SHADOW_METHODS, method / SHADOW_METHODS, views, seen.point, side,
        seen.pixelSize, seen.pixel);
    if (sent.x + sent.y + sent.z <= 0.0) return vec3(0.0);
#endif
#if defined SHADOW_MAPS || defined SHADOW_PLANES || defined SHADOW_SHEETS
    sent *= shadowShare(lightTexel(light, LIGHT_PLACE), views, seen.point, side, seen.pixelSize);
#endif
#ifdef SHADOW_SHEETS
    if (sent.x + sent.y + sent.z > 0.0)
        sent *= shadowSheets(int(lightTexel(light, LIGHT_POWER).w), seen.pixel);
#endif
    return sent;
}

vec3 lightFromAll(Seen seen)
{
    vec3 sum = vec3(0.0);
    for (int i = 0; i < light_plain && lightIsFirst(); i++)
        sum += lightFromPlain(i, seen);
    for (int i = light_plain; i < light_plain + light_points; i++)
        sum += lightFromOther(i, seen);
    return sum;
}

// Returns the light of all lights.
vec3 lightOf(ivec2 pixel, float depth, Surface surface)
{
    Seen seen = lightSeen(pixel, depth, surface);
    return (lightIsFirst() ? lightEven(seen) : vec3(0.0)) + lightFromAll(seen);
}
