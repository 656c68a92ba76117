// What a surface sends to the eye, summed over all lights, in the eye's space: for every pass that lights surfaces. view_space.h says what
// the block and the texels hold. Before it stand the texts that declare Surface and the surface model.
layout(std140) uniform Light {
    vec4 light_ray;
    vec4 light_view;
    vec4 light_ambient;
    int light_plain, light_points, light_areas;
};

// LIGHT_BLOCK texels of all lights, as a block: all pixels read the same one at a time, which takes less than a texture does.
#ifdef LIGHT_BLOCK
layout(std140) uniform Lights {
    vec4 light_texels[LIGHT_BLOCK];
};

vec4 lightNumbers(int texel) { return light_texels[texel]; }
#else
uniform sampler2D light_lights;

const int ROW = 4096;

vec4 lightNumbers(int texel) { return texelFetch(light_lights, ivec2(texel % ROW, texel / ROW), 0); }
#endif

// A light's texel; plain ones have two, and come first.
vec4 lightTexel(int light, int texel)
{
    return lightNumbers(light < light_plain ? 2 * light + texel : 4 * light - 2 * light_plain + texel);
}

// What arrives at a point of a point light that casts no shadow, from the direction l.
vec3 lightPlain(int light, vec3 point, out vec3 l)
{
    vec3 way = lightNumbers(2 * light).xyz - point;
    float over = inversesqrt(max(dot(way, way), 1e-30));
    l = way * over;
    return lightNumbers(2 * light + 1).xyz * (over * over);
}

// What arrives of any other.
vec3 lightAt(int light, vec3 point, out vec3 l)
{
    vec4 place = lightTexel(light, 0);
    vec2 cone = lightTexel(light, 3).xy;
    vec3 way = place.xyz - place.w * point;
    float square = max(dot(way, way), 1e-30);
    l = way * inversesqrt(square);
    float s = clamp(cone.x * -dot(l, lightTexel(light, 2).xyz) + cone.y, 0.0, 1.0);
    return lightTexel(light, 1).xyz * (s * s * (3.0 - 2.0 * s) / (place.w > 0.0 ? square : 1.0));
}

#ifdef LIGHT_HAS_AREAS
// A parallelogram, as a point sees it.
Area areaAt(int light, vec3 point)
{
    return areaSeen(lightTexel(light, 0).xyz - point, lightTexel(light, 2).xyz, lightTexel(light, 3).xyz,
                    lightTexel(light, 1).w > 0.0);
}
#endif

// Of the surface whose depth is `depth`, which is greater than 0, at a pixel.
vec3 lightOf(ivec2 pixel, float depth, Surface surface)
{
    bool orthographic = light_view.y > 0.0;
    vec3 ray = vec3((vec2(2 * pixel + 1) - light_ray.zw) * light_ray.xy, -1.0);
    vec3 point = orthographic ? vec3(ray.xy, (depth - 1.0) * light_view.x) : ray * (light_view.x / depth);
    vec3 toEye = orthographic ? vec3(0.0, 0.0, 1.0) : -normalize(ray);
    float pixelSize = 2.0 * light_ray.x * (orthographic ? 1.0 : -point.z);
    Lit m = surfaceLit(surface, toEye);
    vec3 sum = surfaceOwn(m, light_ambient.xyz);
    for (int i = 0; i < light_plain; i++) {
        vec3 l;
        vec3 arrives = lightPlain(i, point, l);
        sum += arrives * surfaceLobe(m, l);
    }
    int first = light_plain, last = first + light_points;
    for (int i = first; i < last; i++) {
        vec3 l;
        vec3 arrives = lightAt(i, point, l);
        vec3 sent = arrives * surfaceLobe(m, l);
#if defined SHADOW_MAPS || defined SHADOW_PLANES
        if (sent.x + sent.y + sent.z > 0.0)
            sent *= shadowShare(lightTexel(i, 0), ivec2(lightTexel(i, 3).zw), point,
                                dot(m.normal, l) < 0.0 ? -m.normal : m.normal, pixelSize);
#endif
        sum += sent;
    }
#ifdef LIGHT_HAS_SKY
    sum += surfaceSky(m);
#endif
#ifdef LIGHT_HAS_AREAS
    for (int i = last; i < last + light_areas; i++)
        sum += lightTexel(i, 1).xyz * surfaceArea(m, areaAt(i, point));
#endif
    return sum;
}
