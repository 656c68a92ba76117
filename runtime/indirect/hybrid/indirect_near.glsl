// Hit of a ray by two models of the scene, each where it is best. The picture knows surfaces to the
// pixel, but only what it shows; voxels know what is hidden and beside it, but nothing finer than
// themselves, and rays begin a little off. So the picture is asked for the ray's first voxels, and
// takes part only where its depth is conclusive: a place that lies behind what is shown by no more
// than indirect_models.y is in it; farther behind, one cannot know. All else voxels decide.
//
// A hit of the picture sends the light of its pixel, one of voxels cached radiance: that is nearer
// to what paths of light give than pixels that show something close to the hit, and does not change
// with the camera.

// Data that all rays of a point share.
struct IndirectOrigin {
    vec3 point, normal, from; // from: a little off the surface, where what the picture shows is asked from
    vec3 place, up;           // of the grid's units: the point; from there to where voxelStart says
    float lift;               // the length of `up`, in the eye's units
    bool full;                // a full voxel is there, as in a corner
    vec3 seen;                // indirectSeen of `from`
};

// Where the picture shows a point, in pixels times its distance, and that distance, or 1 where all
// is as near: `flat_`, and 0 for a direction.
vec3 indirectSeen(vec3 point, float flat_)
{
    float far = indirectIsOrthographic() ? flat_ : -point.z;
    return vec3(0.5 * (point.xy / indirect_ray.xy + indirect_ray.zw * far), far);
}

IndirectOrigin indirectOrigin(vec3 point, vec3 normal)
{
    vec3 place = voxelPlace(point), along = voxelDirection(normal);
    float size = length(along);
    vec3 up = voxelStart(vec3(0.0), along / size);
    vec3 from = point + (indirect_reach.y + indirect_reach.z * indirectPixelSize(point)) * normal;
    return IndirectOrigin(point, normal, from, place, up, length(up) / size, voxelAt(place + up), indirectSeen(from, 1.0));
}

// Where a ray goes on in voxels: off the surface, where voxelStart says.
struct IndirectStart {
    vec3 place;  // in the grid's units
    float begin; // where the ray is then
    bool full;   // in a full voxel, as in a corner
};

// Off the surface by h, but along the ray, as far as h may take it, and only for the rest along the
// normal: of what is met from a place beside the ray, the distance is another, up to h. Along the
// ray it must not get into what stands beside the point, a wall at a corner: then it is along the
// normal alone. What is at a place h off along the normal, t along a way with a cosine of c, is as
// far from the point as t + h c along it, but for terms of h^2.
//
//     straight up, c = 1: begins h along the ray; at 60 degrees off the normal, c = 1/2: h along
//         the ray, then h / 2 along the normal, begin = h + h / 4
IndirectStart indirectStart(IndirectOrigin origin, vec3 way, vec3 going)
{
    float h = origin.lift, cosine = dot(way, origin.normal), aside = 1.0 - cosine;
    vec3 along = origin.place + h * going + aside * origin.up;
    bool within = voxelAt(along);
    return IndirectStart(within ? origin.place + origin.up : along, within ? h * cosine : h + h * aside * cosine, within && origin.full);
}

#ifdef INDIRECT_NEAR
// Hit on the screen within a ray's first voxels: the first sample behind the depth buffer. All
// samples are read, from the last on, which is faster than to stop where drivers run invocations in
// vectors. The projection of samples, times their distance, is linear along the ray.
bool indirectShownNear(IndirectOrigin origin, vec3 way, float less, inout IndirectHit hit)
{
    bool flat_ = indirectIsOrthographic();
    float radius = indirect_reach.x, step_ = min(indirect_models.x, radius) / float(INDIRECT_STEPS), found = -1.0;
    vec3 going = indirectSeen(way, 0.0);
    for (int j = INDIRECT_STEPS; j >= 1; j--) {
        float s = step_ * (float(j) - less);
        vec3 seen = origin.seen + s * going;
        vec2 at = seen.xy / seen.z;
        bool shown = (flat_ || seen.z > indirect_view.x) && indirectIsShown(at);
        ivec2 pixel = shown ? ivec2(at) : ivec2(0);
        float depth = texelFetch(indirect_depth, pixel, 0).x;
        float behind = flat_ ? (depth - 1.0) * indirect_view.x - origin.from.z - s * way.z : seen.z * depth - indirect_view.x; // times the depth, of a perspective
        if (shown && depth > 0.0 && behind > 0.0 && behind <= indirect_models.y * (flat_ ? 1.0 : depth)) {
            found = s;
            hit.pixel = pixel;
        }
    }
    if (found >= 0.0) hit.t = found / radius;
    return found >= 0.0;
}
#endif

// Hit in voxels, and the light sent from there.
bool indirectVoxel(IndirectOrigin origin, vec3 way, inout IndirectHit hit)
{
    float t, radius = indirect_reach.x;
    vec3 going = voxelDirection(way);
    IndirectStart start = indirectStart(origin, way, going);
    bool met = voxelRay(start.place, going, radius - start.begin, t);
#ifdef INDIRECT_RADIANCE
    RadianceRay ray = RadianceRay(origin.place, start.place, going, met ? t : -1.0, start.full);
    RadianceSum sum = radianceEnd(ray);
    hit.sent = (sum.direct + sum.further) / max(sum.weight, 1e-6);
    met = ray.t >= 0.0;
    t = ray.t;
#endif
    if (met) hit.t = (t + start.begin) / radius;
    return met;
}

IndirectHit indirectMeet(IndirectOrigin origin, vec3 way, float less)
{
    IndirectHit hit = IndirectHit(-1.0, ivec2(-1), vec3(0.0));
#ifdef INDIRECT_NEAR
    if (indirectShownNear(origin, way, less, hit)) {
#if defined INDIRECT_RADIANCE && RADIANCE_TEXELS > 2
        RadianceRay ray = RadianceRay(origin.place, origin.place, voxelDirection(way), hit.t * indirect_reach.x, false);
        RadianceSum sum = radianceEnd(ray);
        hit.sent = sum.further / max(sum.weight, 1e-6);
#endif
        return hit;
    }
#endif
    indirectVoxel(origin, way, hit);
#ifdef INDIRECT_PLANES
    float far = hit.t < 0.0 ? indirect_reach.x : min(hit.t, 1.0) * indirect_reach.x;
    int plane = indirectPlane(origin.point, way, far);
    if (plane >= 0) return IndirectHit(far / indirect_reach.x, indirectShown(plane, origin.point + far * way), vec3(0.0));
#endif
    return hit;
}
