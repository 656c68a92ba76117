// The view positions: the points of all pixels as a mesh, two triangles between the centers of each
// 2 x 2 pixels, viewed from the side (Thiedemann 2009, 4.3). Eye space is rotated around
// positions_middle. Vertices are numbered, six for each 2 x 2 pixels; the depth buffer gives their
// positions.
uniform sampler2D positions_depth;
uniform mat3 positions_turn;
uniform vec4 positions_middle; // center of rotation
uniform vec4 positions_ray, positions_view; // uniforms of view_space.h
uniform vec4 positions_clip;   // scales of x, y and z; w: offset of z
uniform vec4 positions_w;      // clip space w: x is the scale of z, y the offset
out vec3 position;
// 1: surface in the depth buffer; 0: triangle between two surfaces, where the depth buffer has no
// data
flat out float position_known;

const float STEEPEST = 1.0 / 16.0; // min cosine between a triangle's normal and the line of sight

vec3 pointOf(ivec2 pixel, float depth)
{
    vec3 ray = vec3((vec2(2 * pixel + 1) - positions_ray.zw) * positions_ray.xy, -1.0);
    return positions_view.y > 0.0 ? vec3(ray.xy, (depth - 1.0) * positions_view.x)
        : ray * (positions_view.x / depth);
}

void main()
{
    const ivec2 corners[6] = ivec2[6](ivec2(0, 0), ivec2(1, 0), ivec2(1, 1), ivec2(0, 0),
        ivec2(1, 1), ivec2(0, 1));
    int across = textureSize(positions_depth, 0).x - 1, square = gl_VertexID / 6,
        corner = gl_VertexID % 6;
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
    gl_Position = there ? vec4(positions_clip.xy * position.xy, positions_clip.z * position.z +
        positions_clip.w,
                               positions_w.x * position.z + positions_w.y)
                        : vec4(2.0, 2.0, 2.0, 1.0);
}
