// The view positions: the points that pixels show, as a mesh of two triangles between each four
// pixels' middles, seen from beside (Thiedemann 2009, 4.3). The eye's space is turned around a
// point of it; vertices are numbered, six for each four pixels, and depth says where they are.
uniform sampler2D positions_depth;
uniform mat3 positions_turn;
uniform vec4 positions_middle; // around which it is turned
uniform vec4 positions_ray, positions_view; // of view_space.h
uniform vec4 positions_clip;   // of x and y; of z, and what is added there
uniform vec4 positions_w;      // of z, and what is added
out vec3 position;
flat out float position_known; // 1; 0: between two surfaces, of what lies there the picture knows nothing

const float STEEPEST = 1.0 / 16.0; // cosine between a triangle's normal and the line of sight

vec3 pointOf(ivec2 pixel, float depth)
{
    vec3 ray = vec3((vec2(2 * pixel + 1) - positions_ray.zw) * positions_ray.xy, -1.0);
    return positions_view.y > 0.0 ? vec3(ray.xy, (depth - 1.0) * positions_view.x) : ray * (positions_view.x / depth);
}

void main()
{
    const ivec2 corners[6] = ivec2[6](ivec2(0, 0), ivec2(1, 0), ivec2(1, 1), ivec2(0, 0), ivec2(1, 1), ivec2(0, 1));
    int across = textureSize(positions_depth, 0).x - 1, square = gl_VertexID / 6, corner = gl_VertexID % 6;
    ivec2 low = ivec2(square % across, square / across);
    vec3 points[3];
    bool there = true;
    for (int i = 0; i < 3; i++) {
        ivec2 pixel = low + corners[corner / 3 * 3 + i];
        float depth = texelFetch(positions_depth, pixel, 0).x;
        there = there && depth > 0.0;
        points[i] = pointOf(pixel, max(depth, 1e-30));
    }
    vec3 normal = cross(points[1] - points[0], points[2] - points[0]);
    vec3 sight = positions_view.y > 0.0 ? vec3(0.0, 0.0, 1.0) : normalize(points[0]);
    position_known = abs(dot(normal, sight)) < STEEPEST * length(normal) ? 0.0 : 1.0;
    position = positions_turn * (points[corner % 3] - positions_middle.xyz) + positions_middle.xyz;
    gl_Position = there ? vec4(positions_clip.xy * position.xy, positions_clip.z * position.z + positions_clip.w,
                               positions_w.x * position.z + positions_w.y)
                        : vec4(2.0, 2.0, 2.0, 1.0);
}
