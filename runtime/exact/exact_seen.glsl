// The point of the opaque surface at a pixel, as exact as its triangle's corners. The depth buffer
// is too inexact, since a rasterizer rounds corners to 1/256 of a pixel.
vec3 exact_point; // position of the lit pixel

// Finds the intersection of a ray with a triangle: a weighted mean of the corners, so that the
// point is on the triangle even at grazing angles.
bool exactOn(uint triangle, ExactRay ray, out vec3 point)
{
    vec3 a = exactCorner(triangle, 0u), b = exactCorner(triangle, 1u),
        c = exactCorner(triangle, 2u);
    vec3 areas = exactAreas(exactSeen(ray, a), exactSeen(ray, b), exactSeen(ray, c));
    areas = max(areas.x + areas.y + areas.z < 0.0 ? -areas : areas, 0.0);
    float area = areas.x + areas.y + areas.z;
    vec3 part = areas / max(area, 1e-37);
    point = a + part.y * (b - a) + part.z * (c - a);
    return area > 0.0;
}

// Finds the point of a pixel. `start` and `way` are the pixel's ray in eye space, z of the
// direction -1; `seen` is the point by depth. Infinite planes nearer than the triangle are
// intersected as exactly; those in front of `near` are not visible.
void exactFind(ivec2 pixel, vec3 start, vec3 way, vec3 seen, float near)
{
    vec3 from = exact_eye.xyz + exactDirection(start), along = exactDirection(way), on;
    uint number = texelFetch(shadow_seen, pixel, 0).x;
    float nearest = 3e38;
    exact_point = exact_eye.xyz + exactDirection(seen);
    if (number != 0u && exactOn(number - 1u, exactRay(from, along), on)) {
        exact_point = on;
        nearest = -dot(on - exact_eye.xyz, exact_back.xyz);
    }
#ifdef SHADOW_PLANES
    for (int i = 0; i < SHADOW_PLANES; i++) {
        vec4 plane = shadowPlane(i);
        float far = -dot(plane, vec4(start, 1.0)) / dot(plane.xyz, way);
        if (!(far > near && far < nearest)) continue;
        exact_point = from + far * along;
        nearest = far;
    }
#endif
}

vec3 exactPoint(vec3 point, vec3 normal, float pixel) { return exact_point; }

// Finds the surface point at a pixel (entry point, called by shadow_text.c's functions).
void exactAtPixel(ivec2 pixel, float depth, vec3 point, vec4 ray, vec4 view)
{
    bool orthographic = view.y > 0.0;
    vec3 way = vec3((vec2(2 * pixel + 1) - ray.zw) * ray.xy, -1.0);
    exactFind(pixel, orthographic ? vec3(way.xy, 0.0) : vec3(0.0),
        orthographic ? vec3(0.0, 0.0, -1.0) : way, point,
              orthographic ? 0.0 : view.x);
}
