// The plane of the triangle that a pixel shows, for silhouette shadows; triangle_slopes.glsl writes
// it.

// normal of the lit pixel's triangle, towards the eye; 0: unknown, the shading normal is used
vec3 triangle_normal = vec3(0.0);

// Reconstructs the triangle's normal from depth slopes. `point` is in eye space; a pixel's ray has
// z = -1, or for an orthographic camera x and y are the point's; `ray` and `view` are those of
// view_space.h. Depth is linear over the picture, in the ray's x and y: d = k (n.x x + n.y y -
// n.z), or for an orthographic camera 1 + z / view.x.
//
//  a plane z = -4 with near .01: d is .0025 everywhere, both slopes are 0, and the normal is (0, 0,
//  1)
void triangleFind(ivec2 pixel, float depth, vec3 point, vec4 ray, vec4 view)
{
    uint word = texelFetch(shadow_seen, pixel, 0).x;
    triangle_normal = vec3(0.0);
    if (word == 0u) return;
#ifdef SHADOW_PLANES
    for (int i = 0; i < SHADOW_PLANES; i++) // an infinite plane hides the triangle
        if (abs(dot(shadowPlane(i), vec4(point, 1.0))) <= 4e-6 *
            (length(point) + abs(shadowPlane(i).w)))
            return;
#endif
    vec2 slope = unpackHalf2x16(word) * (depth / 4096.0) / (2.0 * ray.xy);
    vec2 place = (vec2(2 * pixel + 1) - ray.zw) * ray.xy;
    triangle_normal = normalize(view.y > 0.0 ? vec3(-view.x * slope, 1.0)
        : vec3(-slope, depth - dot(slope, place)));
}

// Prepares for a light in direction l the variables that silhouette.glsl reads.
void triangleTurn(vec3 normal, vec3 l)
{
    float toward = dot(triangle_normal, l);
    triangle_side = toward < 0.0 ? -triangle_normal : triangle_normal;
    triangle_away = toward * dot(normal, l) < 0.0;
}
