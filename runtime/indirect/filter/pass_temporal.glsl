// The pass temporal: temporal accumulation. Each pixel's point is reprojected into the previous
// frame. A sample there counts if it shows the same surface, by its distance from the tangent plane
// and by its normal. It is weighted by the number of its sets of rays. Preceded by
// indirect_place.glsl.
//
// A pixel of a moved object is looked up where the object's point was, by its motion id.
//
// A moving occluder or lamp leaves stale samples on surfaces that did not change themselves.
// Ambient occlusion can change only where a ray reaches a moved object's bounding box, at its old
// or new position; there, and where indirect light can change, kept samples are clamped to the
// neighborhood of the pixel's current rays.
uniform sampler2D temporal_rays;   // results of this frame's rays
uniform sampler2D temporal_values; // accumulated means
// x: distance from the eye along the view axis; y: number of sets; zw: the normal
uniform sampler2D temporal_places;
// motion ids, from 1 on; 0: no motion; an id past the last: the motion is unknown
uniform usampler2D temporal_moved;
layout(std140) uniform History {
#include "temporal.layout.def"
};

#define TEMPORAL_MATRIX(name, i) mat4(name[i], name[(i) + 1], name[(i) + 2], name[(i) + 3])

struct TemporalKept {
    vec4 value;
    float sets;
};

// Encodes a unit vector as two numbers, and decodes them: octahedral mapping, |x| + |y| + |z| = 1
// unfolded to a square (Meyer et al. 2010).
vec2 temporalPack(vec3 n)
{
    n /= abs(n.x) + abs(n.y) + abs(n.z);
    return n.z >= 0.0 ? n.xy : (1.0 - abs(n.yx)) *
        vec2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0);
}

vec3 temporalUnpack(vec2 p)
{
    vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    if (n.z < 0.0) n.xy = (1.0 - abs(n.yx)) * vec2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0);
    return normalize(n);
}

// Returns the history of a point `was` with normal `turned`, in the previous eye space: bilinear
// interpolation over the four pixels nearest to its reprojection. Zero sets: rejected, since the
// surface differs.
TemporalKept temporalAt(vec3 was, vec3 turned)
{
    TemporalKept kept = TemporalKept(vec4(0.0), 0.0);
    bool orthographic = temporal_view.y > 0.0;
    if (!orthographic && -was.z <= temporal_view.x) return kept;
    vec2 place = 0.5 * ((orthographic ? was.xy : was.xy / -was.z) / temporal_ray.xy +
        temporal_ray.zw);
    vec2 shown = (place - 0.5 - float(INDIRECT_COARSE / 2)) / float(INDIRECT_COARSE),
        part = fract(shown);
    ivec2 size = textureSize(temporal_values, 0);
    float width = 2.0 * temporal_ray.x * (orthographic ? 1.0 : -was.z) * float(INDIRECT_COARSE),
        sum = 0.0;
    for (int i = 0; i < 4; i++) {
        ivec2 beside = ivec2(i & 1, i >> 1), tap = ivec2(floor(shown)) + beside;
        if (any(lessThan(tap, ivec2(0))) || any(greaterThanEqual(tap, size))) continue;
        vec4 there = texelFetch(temporal_places, tap, 0);
        if (there.y <= 0.0) continue;
        vec2 ray = (vec2(2 * (tap * INDIRECT_COARSE + INDIRECT_COARSE / 2) + 1) - temporal_ray.zw) *
            temporal_ray.xy;
        vec3 other = orthographic ? vec3(ray, -there.x) : vec3(ray, -1.0) * there.x;
        if (abs(dot(turned, other - was)) > width || dot(turned, temporalUnpack(there.zw)) < 0.9)
            continue;
        vec2 share = mix(1.0 - part, part, vec2(beside));
        float weight = share.x * share.y;
        kept.value += weight * texelFetch(temporal_values, tap, 0);
        kept.sets += weight * there.y;
        sum += weight;
    }
    if (sum < 0.05) return TemporalKept(vec4(0.0), 0.0);
    return TemporalKept(kept.value / sum, kept.sets / sum);
}

// Temporal reprojection of a pixel. Incoming light depends more on a surface's position and normal
// than on the surface. So samples of a moved object are first looked up as if it had only been
// translated with its center. Its exact motion, with rotation, is tried only if that lookup is
// rejected.
TemporalKept temporalFind(ivec2 at, vec3 point, vec3 normal)
{
    if (temporal_limits.y == 0.0) return TemporalKept(vec4(0.0), 0.0);
    if (temporal_limits.z == 1.0)
        return TemporalKept(texelFetch(temporal_values, at, 0),
            texelFetch(temporal_places, at, 0).y);
    mat4 from_eye = TEMPORAL_MATRIX(temporal_from_eye, 0);
    vec3 was = (from_eye * vec4(point, 1.0)).xyz, turned = mat3(from_eye) * normal;
    int number = temporal_counts.x > 0.0 ? int(texelFetch(temporal_moved, indirectPixel(at), 0).x)
        : 0;
    if (float(number) > temporal_counts.y) return TemporalKept(vec4(0.0), 0.0);
    if (number == 0) return temporalAt(was, turned);
    TemporalKept kept = temporalAt(was + temporal_steps[number - 1].xyz, turned);
    if (kept.sets > 0.0) return kept;
    // Normals transform by the cofactor matrix, the inverse transpose up to a factor.
    mat4 motion = TEMPORAL_MATRIX(temporal_motions, 4 * number - 4);
    vec3 c0 = motion[0].xyz, c1 = motion[1].xyz, c2 = motion[2].xyz;
    turned = sign(dot(c0, cross(c1, c2))) *
        normalize(mat3(cross(c1, c2), cross(c2, c0), cross(c0, c1)) * normal);
    return temporalAt((motion * vec4(point, 1.0)).xyz, turned);
}

// Reports whether a ray from the point may reach a moved object.
bool temporalIsNear(vec3 point)
{
    vec3 world = (TEMPORAL_MATRIX(temporal_world, 0) * vec4(point, 1.0)).xyz;
    for (int i = 0; i < int(temporal_counts.x); i++) {
        vec3 beyond =
            max(max(temporal_boxes[2 * i].xyz - world, world - temporal_boxes[2 * i + 1].xyz),
            vec3(0.0));
        if (dot(beyond, beyond) < temporal_dirty.z * temporal_dirty.z) return true;
    }
    return false;
}

// Clamps history to a neighborhood of 4 x 4 pixels that lie on the tangent plane. Their mean has an
// error of a fourth of their standard deviation if they are independent, and less if they share one
// low-discrepancy net. Samples are clamped to the mean within 1.5 of that error; their weight falls
// with the distance by which they were outside.
void temporalLimit(inout TemporalKept kept, ivec2 at, vec3 point, vec3 normal)
{
    bvec2 dirty = greaterThan(temporal_dirty.xy, vec2(0.0));
    dirty.y = dirty.y || temporalIsNear(point);
    if (!any(dirty)) return;
    vec4 sum = vec4(0.0), squares = vec4(0.0);
    float count = 0.0, width = indirectPixelSize(point) * float(INDIRECT_COARSE);
    ivec2 size = textureSize(temporal_rays, 0);
    for (int y = -2; y < 2; y++)
        for (int x = -2; x < 2; x++) {
            ivec2 beside = clamp(at + ivec2(x, y), ivec2(0), size - 1),
                pixel = indirectPixel(beside);
            float depth = texelFetch(indirect_depth, pixel, 0).x;
            if (depth <= 0.0 || abs(dot(normal, indirectPoint(pixel, depth) - point)) > 2.0 * width)
                continue;
            vec4 found = texelFetch(temporal_rays, beside, 0);
            sum += found;
            squares += found * found;
            count += 1.0;
        }
    if (count == 0.0) return;
    vec4 mean = sum / count, off =
        1.5 * sqrt(max(squares / count - mean * mean, vec4(0.0)) / count);
    vec4 limited = clamp(kept.value, mean - off, mean + off),
        beyond = abs(kept.value - limited) / (off + 1e-4);
    if (dirty.x) kept.value.xyz = limited.xyz;
    if (dirty.y) kept.value.w = limited.w;
    float most = max(dirty.x ? max(max(beyond.x, beyond.y), beyond.z) : 0.0, dirty.y ? beyond.w
        : 0.0);
    kept.sets *= clamp(1.0 - most, 0.0, 1.0);
}

vec4 passPixel(ivec2 at)
{
    ivec2 pixel = indirectPixel(at);
    float depth = texelFetch(indirect_depth, pixel, 0).x;
#ifdef TEMPORAL_PLACE
    if (depth <= 0.0) return vec4(0.0);
#else
    if (depth <= 0.0) return vec4(0.0, 0.0, 0.0, 1.0);
#endif
    vec3 point = indirectPoint(pixel, depth), normal = indirectNormal(pixel);
    TemporalKept kept = temporalFind(at, point, normal);
    if (kept.sets > 0.0 && temporal_limits.z != 1.0) temporalLimit(kept, at, point, normal);
    float sets = min(kept.sets, temporal_limits.x - 1.0) + 1.0;
#ifdef TEMPORAL_PLACE
    return vec4(-point.z, sets, temporalPack(normal));
#else
    vec4 now = texelFetch(temporal_rays, at, 0);
    return mix(kept.value, now, 1.0 / sets);
#endif
}
