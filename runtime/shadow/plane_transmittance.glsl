// Transmittance of a plane towards a light, for each pixel. Follows a plane's fragment program,
// whose main() is renamed to surfaceMain(), and whose input worldRay is a variable. The ray from
// the pixel's surface point to the light intersects the plane, and the program is evaluated for the
// ray from sheet_eye to the intersection. If the plane is not in between, the program is evaluated
// at an existing point and its result ignored. fragment0 contains three floats.
//
// The result is multiplied into the light's layer: three components of 21 bits, as in
// glass_store.glsl.
layout(std140) uniform PlaneTransmittance {
    mat4 sheet_worldFromEye;
    vec4 sheet_ray; // ray of a pixel, like light_ray and light_view
    vec4 sheet_view;
    // light in eye space: its position, and 1; or the direction to the light, and 0
    vec4 sheet_light;
    vec4 sheet_plane; // the plane in eye space
    vec3 sheet_eye;   // eye of the program in world space, on the light's side of the plane
    vec3 sheet_foot;  // the plane's point nearest to sheet_eye
    int sheet_layer;  // layer of the light
    int sheet_more;   // 1: the layer already contains earlier planes
    int sheet_cut;    // 1: alpha test, which transmits all light or none
};
uniform sampler2D sheet_depth;
layout(rg32ui) uniform uimage2DArray sheet_layers;

vec3 sheetSeen(ivec2 pixel, float depth)
{
    vec3 ray = vec3((vec2(2 * pixel + 1) - sheet_ray.zw) * sheet_ray.xy, -1.0);
    return sheet_view.y > 0.0 ? vec3(ray.xy, (depth - 1.0) * sheet_view.x)
        : ray * (sheet_view.x / depth);
}

// Returns true if the plane separates the point from the light, like shadowBetween(); `met` is the
// intersection.
bool sheetBetween(vec3 point, out vec3 met)
{
    float here = dot(sheet_plane, vec4(point, 1.0)), there = dot(sheet_plane, sheet_light);
    met = point + here / (sheet_light.w * here - there) * (sheet_light.xyz - sheet_light.w * point);
    return here * there < 0.0 && abs(here) > 4e-6 * (length(point) + abs(sheet_plane.w));
}

vec3 sheetThrough(vec3 through)
{
    return sheet_cut > 0 ? vec3(through.x + through.y + through.z > 1.5) : clamp(through, 0.0, 1.0);
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec3 texel = ivec3(pixel, sheet_layer);
    float depth = texelFetch(sheet_depth, pixel, 0).x;
    vec3 met, through = vec3(1.0);
    bool between = depth > 0.0 && sheetBetween(sheetSeen(pixel, depth), met);
    worldRay = (between ? (sheet_worldFromEye * vec4(met, 1.0)).xyz : sheet_foot) - sheet_eye;
    surfaceMain();
    if (between) through = sheetThrough(uintBitsToFloat(fragment0.xyz));
    if (sheet_more > 0) {
        uvec2 words = imageLoad(sheet_layers, texel).xy;
        through *= vec3(words.x & 2097151u, words.x >> 21 | (words.y & 1023u) << 11,
            words.y >> 10) / 2097151.0;
    }
    uvec3 shares = uvec3(through * 2097151.0 + 0.5);
    imageStore(sheet_layers, texel,
        uvec4(shares.x | shares.y << 21, shares.y >> 11 | shares.z << 10, 0u, 0u));
}
