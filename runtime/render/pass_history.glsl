// The pass history: what rays found, with what they found in frames before, as the mean over both. Where the point of a pixel was seen before says the view of that frame; what is
// there counts if it is the same surface, by its distance off the tangent plane and by its normal, and as much as it is made of sets of rays. Behind indirect_place.glsl.
//
// What moves, or lights what others send, leaves a wrong value behind where nothing tells by the surface. So unless nothing has changed, what was kept is brought near
// the mean of what rays find around the pixel now.
uniform sampler2D history_rays;   // of this frame
uniform sampler2D history_values; // kept: the same, as means
uniform sampler2D history_places; // x: distance from the eye, along its axis; y: sets of rays; zw: the normal
layout(std140) uniform History {
    mat4 history_from_eye;           // the eye's space of the frame before, from that of this one
    vec4 history_ray, history_view;  // of the frame before: indirect_ray, indirect_view
    vec4 history_limits;             // x: so many sets of rays count, at most; y: 1: something is kept; z: 1: nothing has changed
};

struct HistoryKept {
    vec4 value;
    float sets;
};

// A unit vector as two numbers, and back: the octahedron |x| + |y| + |z| = 1, unfolded to a square (Meyer et al. 2010).
vec2 historyPack(vec3 n)
{
    n /= abs(n.x) + abs(n.y) + abs(n.z);
    return n.z >= 0.0 ? n.xy : (1.0 - abs(n.yx)) * vec2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0);
}

vec3 historyUnpack(vec2 p)
{
    vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    if (n.z < 0.0) n.xy = (1.0 - abs(n.yx)) * vec2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0);
    return normalize(n);
}

// What was kept of a point, between the pixels that are nearest to where it was seen. No sets: nothing.
HistoryKept historyFind(ivec2 at, vec3 point, vec3 normal)
{
    HistoryKept kept = HistoryKept(vec4(0.0), 0.0);
    if (history_limits.y == 0.0) return kept;
    if (history_limits.z == 1.0) return HistoryKept(texelFetch(history_values, at, 0), texelFetch(history_places, at, 0).y);
    bool orthographic = history_view.y > 0.0;
    vec3 was = (history_from_eye * vec4(point, 1.0)).xyz, turned = mat3(history_from_eye) * normal;
    if (!orthographic && -was.z <= history_view.x) return kept;
    vec2 place = 0.5 * ((orthographic ? was.xy : was.xy / -was.z) / history_ray.xy + history_ray.zw);
    vec2 shown = (place - 0.5 - float(INDIRECT_COARSE / 2)) / float(INDIRECT_COARSE), part = fract(shown);
    ivec2 size = textureSize(history_values, 0);
    float width = 2.0 * history_ray.x * (orthographic ? 1.0 : -was.z) * float(INDIRECT_COARSE), sum = 0.0;
    for (int i = 0; i < 4; i++) {
        ivec2 beside = ivec2(i & 1, i >> 1), tap = ivec2(floor(shown)) + beside;
        if (any(lessThan(tap, ivec2(0))) || any(greaterThanEqual(tap, size))) continue;
        vec4 there = texelFetch(history_places, tap, 0);
        if (there.y <= 0.0) continue;
        vec2 ray = (vec2(2 * (tap * INDIRECT_COARSE + INDIRECT_COARSE / 2) + 1) - history_ray.zw) * history_ray.xy;
        vec3 other = orthographic ? vec3(ray, -there.x) : vec3(ray, -1.0) * there.x;
        if (abs(dot(turned, other - was)) > width || dot(turned, historyUnpack(there.zw)) < 0.9) continue;
        vec2 share = mix(1.0 - part, part, vec2(beside));
        float weight = share.x * share.y;
        kept.value += weight * texelFetch(history_values, tap, 0);
        kept.sets += weight * there.y;
        sum += weight;
    }
    if (sum < 0.05) return HistoryKept(vec4(0.0), 0.0);
    return HistoryKept(kept.value / sum, kept.sets / sum);
}

// Of 16 pixels around, one in two of 8 x 8, those that show the tangent plane to within their distance: their mean, which is off by a fourth of their deviation if they have nothing
// to do with each other, and by less if they have one net of rays. What was kept is brought to within 1.5 of that, and counts the less the farther it was off.
void historyLimit(inout HistoryKept kept, ivec2 at, vec3 point, vec3 normal)
{
    vec4 sum = vec4(0.0), squares = vec4(0.0);
    float count = 0.0, width = indirectPixelSize(point) * float(INDIRECT_COARSE);
    ivec2 size = textureSize(history_rays, 0);
    for (int y = -3; y <= 3; y += 2)
        for (int x = -3; x <= 3; x += 2) {
            ivec2 beside = clamp(at + ivec2(x, y), ivec2(0), size - 1), pixel = indirectPixel(beside);
            float depth = texelFetch(indirect_depth, pixel, 0).x;
            if (depth <= 0.0 || abs(dot(normal, indirectPoint(pixel, depth) - point)) > 2.0 * width) continue;
            vec4 found = texelFetch(history_rays, beside, 0);
            sum += found;
            squares += found * found;
            count += 1.0;
        }
    if (count == 0.0) return;
    vec4 mean = sum / count, off = 1.5 * sqrt(max(squares / count - mean * mean, vec4(0.0)) / count);
    vec4 limited = clamp(kept.value, mean - off, mean + off), beyond = abs(kept.value - limited) / (off + 1e-4);
    kept.value = limited;
    kept.sets *= clamp(1.0 - max(max(beyond.x, beyond.y), max(beyond.z, beyond.w)), 0.0, 1.0);
}

vec4 passPixel(ivec2 at)
{
    ivec2 pixel = indirectPixel(at);
    float depth = texelFetch(indirect_depth, pixel, 0).x;
#ifdef HISTORY_PLACE
    if (depth <= 0.0) return vec4(0.0);
#else
    if (depth <= 0.0) return vec4(0.0, 0.0, 0.0, 1.0);
#endif
    vec3 point = indirectPoint(pixel, depth), normal = indirectNormal(pixel);
    HistoryKept kept = historyFind(at, point, normal);
    if (kept.sets > 0.0 && history_limits.z != 1.0) historyLimit(kept, at, point, normal);
    float sets = min(kept.sets, history_limits.x - 1.0) + 1.0;
#ifdef HISTORY_PLACE
    return vec4(-point.z, sets, historyPack(normal));
#else
    vec4 now = texelFetch(history_rays, at, 0);
    return mix(kept.value, now, 1.0 / sets);
#endif
}
