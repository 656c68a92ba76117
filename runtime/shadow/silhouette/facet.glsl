// The plane of the triangle that a pixel sees, where shadows are found by silhouettes;
// facet_slopes.glsl writes it.

vec3 facet_normal = vec3(0.0); // of the pixel that is lit, towards the eye; 0: it is not known, and the surface's own normal is taken

// `point` is in the eye's space; of the pixel's ray z is -1, or, orthographic, x and y are the
// point's; `ray` and `view` are of view_space.h. Depth is linear over the picture, in the ray's x
// and y: d = k (n.x x + n.y y - n.z), or, orthographic, 1 + z / view.x.
//
//     a plane z = -4 before near .01: d is .0025 everywhere, both slopes are 0, and the normal is
//         (0, 0, 1)
void facetFind(ivec2 pixel, float depth, vec3 point, vec4 ray, vec4 view)
{
    uint word = texelFetch(shadow_seen, pixel, 0).x;
    facet_normal = vec3(0.0);
    if (word == 0u) return;
#ifdef SHADOW_PLANES
    for (int i = 0; i < SHADOW_PLANES; i++) // it is drawn over a triangle
        if (abs(dot(shadowPlane(i), vec4(point, 1.0))) <= 4e-6 * (length(point) + abs(shadowPlane(i).w))) return;
#endif
    vec2 slope = unpackHalf2x16(word) * (depth / 4096.0) / (2.0 * ray.xy);
    vec2 place = (vec2(2 * pixel + 1) - ray.zw) * ray.xy;
    facet_normal = normalize(view.y > 0.0 ? vec3(-view.x * slope, 1.0) : vec3(-slope, depth - dot(slope, place)));
}

// For a light in direction l: silhouette.glsl reads these.
void facetTurn(vec3 normal, vec3 l)
{
    float toward = dot(facet_normal, l);
    facet_side = toward < 0.0 ? -facet_normal : facet_normal;
    facet_away = toward * dot(normal, l) < 0.0;
}
