// Appended to the fragment program of a ray-marched surface (trace_text.h): interpolates attributes
// of the hit's triangle, runs the vertex program's computations at the hit and at both neighboring
// pixels on the tangent plane, whose differences are the screen-space derivatives; then runs the
// program's own main.
uniform usampler2D trace_met;
uniform vec2 trace_pixel; // a pixel's size in clip space
uniform int trace_hull;   // number of triangles of a hull
uniform float trace_turn; // -1 for a negative determinant, which flips the winding; else 1
flat in uint trace_place;

struct TraceCorners {
    int rows[3];
    vec2 at; // position of the first row, in parts
    bool between;
};

TraceCorners traceFound(int number, vec2 at)
{
    TraceCorners found;
    ivec2 corners[3];
    vec2 scaled = at * float(trace_parts);
    ivec2 whole = clamp(ivec2(floor(scaled)), ivec2(0), ivec2(trace_parts - 1));
    whole.y = min(whole.y, whole.x);
    vec2 rest = scaled - vec2(whole);
    TracePart part = TracePart(0, whole, rest.y > rest.x && whole.y < whole.x);
    traceCorners(part, corners);
    for (int i = 0; i < 3; i++)
        found.rows[i] = traceRow(number, corners[i]);
    found.at = vec2(whole);
    found.between = part.between;
    return found;
}

vec3 traceWeights(TraceCorners corners, vec2 at)
{
    vec2 rest = at * float(trace_parts) - corners.at;
    vec2 w = corners.between ? vec2(rest.x, rest.y - rest.x) : vec2(rest.x - rest.y, rest.y);
    return vec3(1.0 - w.x - w.y, w);
}

vec3 traceMixed(TraceCorners corners, vec3 w, int part)
{
    return traceVector(corners.rows[0], part) * w.x + traceVector(corners.rows[1], part) * w.y +
        traceVector(corners.rows[2], part) * w.z;
}

void traceAttributes(TraceCorners corners, vec2 at)
{
    vec3 w = traceWeights(corners, at);
    trace_position = traceMixed(corners, w, TRACE_POSITION);
    trace_normal = traceMixed(corners, w, TRACE_NORMAL);
    trace_texcoord = traceMixed(corners, w, TRACE_TEXCOORD).xy;
    trace_tangentU = traceMixed(corners, w, TRACE_TANGENT_U);
    trace_tangentV = traceMixed(corners, w, TRACE_TANGENT_V);
    trace_basePosition = traceMixed(corners, w, TRACE_BASE);
    traceRun();
}

// Returns the derivatives of the screen position, in clip space, by a and b, as columns.
mat2 traceScreen(TraceCorners corners, vec2 at)
{
    const vec2 one = vec2(1.0, 0.0);
    vec4 clip = trace_clip;
    float parts = float(trace_parts);
    vec3 here = trace_position;
    vec3 byA = traceMixed(corners, traceWeights(corners, at + one.xy / parts), TRACE_POSITION) -
        here;
    vec3 byB = traceMixed(corners, traceWeights(corners, at + one.yx / parts), TRACE_POSITION) -
        here;
    mat4 clipFromLocal = matc_clipFromWorld * matc_instances[trace_place].worldFromLocal;
    vec4 a = clipFromLocal * vec4(byA, 0.0) * parts, b = clipFromLocal * vec4(byB, 0.0) * parts;
    return mat2((a.xy - clip.xy / clip.w * a.w) / clip.w, (b.xy - clip.xy / clip.w * b.w) / clip.w);
}

void main()
{
    uvec4 met = texelFetch(trace_met, ivec2(gl_FragCoord.xy), 0);
    int number = gl_PrimitiveID / trace_hull;
    if (met.w != trace_place + 1u || met.z != uint(number))
        discard;
    matc_instance = trace_place;
    vec2 at = uintBitsToFloat(met.xy);
    TraceCorners corners = traceFound(number, at);
    traceAttributes(corners, at);
    mat2 screen = traceScreen(corners, at);
    float turn = determinant(screen);
    trace_front = turn * trace_turn > 0.0;
#ifdef TRACE_CHANGES
    mat2 changes = abs(turn) > 0.0 ? inverse(screen) : mat2(0.0);
    traceAttributes(corners, at + changes[0] * trace_pixel.x);
    traceKeepX();
    traceAttributes(corners, at + changes[1] * trace_pixel.y);
    traceKeepY();
    traceAttributes(corners, at);
    traceSubtract();
#endif
    traceSurfaceMain();
}
