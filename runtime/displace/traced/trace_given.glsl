// Inputs of ray-marching programs, and their outputs: the depth, and data to find the hit again: a
// and b (trace_patch.glsl), the patch and the instance.
layout(std430, binding = 5) readonly buffer TraceNodes {
    vec4 trace_nodes[];
};
uniform vec2 trace_pixel;  // a pixel's size in clip space
uniform vec2 trace_corner; // clip-space position of gl_FragCoord 0
// approximate point in object space where the ray leaves the hull
in vec3 trace_leaves;
// perspective: the eye, and 1; parallel rays: the direction toward the eye, and 0
flat in vec4 trace_eye;
flat in mat4 trace_clipFromLocal;
flat in uint trace_place;
layout(location = 0) out uvec4 trace_seen;

// Returns the point of the pixel's exact ray that is nearest to trace_leaves. A GPU's rasterizer
// moves corners by up to 1/256 of a pixel, and with them the interpolated values. The point is
// projected to the line where two planes through the pixel's center intersect, one of constant x
// and one of constant y. The center is x = 0.5 and y = 0; clip space is object space, w = 1: the
// point (0.501, 0.001, 7) becomes (0.5, 0, 7).
vec3 traceLeaves()
{
    vec2 pixel = gl_FragCoord.xy * trace_pixel + trace_corner;
    mat4 rows = transpose(trace_clipFromLocal);
    vec4 x = rows[0] - pixel.x * rows[3], y = rows[1] - pixel.y * rows[3],
        place = vec4(trace_leaves, 1.0);
    vec2 off = vec2(dot(x, place), dot(y, place));
    float xx = dot(x.xyz, x.xyz), xy = dot(x.xyz, y.xyz), yy = dot(y.xyz, y.xyz),
        size = xx * yy - xy * xy;
    if (size <= 0.0)
        return trace_leaves;
    return trace_leaves - ((off.x * yy - off.y * xy) * x.xyz + (off.y * xx - off.x * xy) * y.xyz) /
        size;
}

// Returns the vector from the eye to the point where the ray leaves the hull; for parallel rays the
// direction.
vec3 traceWay(vec3 leaves) { return trace_eye.w > 0.0 ? leaves - trace_eye.xyz : -trace_eye.xyz; }

// Writes the hit of the patch. Returns its position in clip space.
vec4 traceMeet(int number, vec2 at, vec3 place)
{
    vec4 clip = trace_clipFromLocal * vec4(place, 1.0);
    gl_FragDepth = clip.z / clip.w;
    trace_seen = uvec4(floatBitsToUint(at), uint(number), trace_place + 1u);
    return clip;
}
