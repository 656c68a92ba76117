// Ray hit by two models of the scene. The depth buffer has surfaces exact to the pixel, but only
// visible ones; voxels also have hidden and off-screen surfaces, but no finer detail, and rays
// begin a little off the surface. So a ray tests the depth buffer along its first voxels, and
// accepts a hit only if the depth is conclusive: a point at most indirect_models.y behind the
// visible surface is inside it; farther behind, the depth buffer cannot tell. Voxels decide the
// rest.
//
// A hit in screen space returns the light of its pixel, a hit in voxels cached radiance. That is
// closer to path-traced light than the pixel of a surface near the hit, and does not change with
// the camera.

// Data that all rays of a point share.
struct IndirectOrigin {
    vec3 point, normal, from; // `from` is the start of screen-space rays, a little off the surface
    vec3 place, up;           // in grid units: the point, and the offset from it to voxelStart()
    float lift;               // length of `up` in eye-space units
    bool full;                // the start lies in a full voxel, as in a corner
    vec3 seen;                // result of indirectSeen() for `from`
};

// Homogeneous projection of a point: xy: pixel position times distance; z: distance. In an
// orthographic view z is `flat_`, which is 1 for a point and 0 for a direction.
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
    return IndirectOrigin(point, normal, from, place, up, length(up) / size, voxelAt(place + up),
        indirectSeen(from, 1.0));
}

// Start of a ray in voxels, off the surface.
struct IndirectStart {
    vec3 place;  // start of the ray in the grid's units
    float begin; // distance along the ray of the start
    bool full;   // the start lies in a full voxel, as in a corner
};

// Starts a ray at height h over the surface, moved along the ray as far as possible and only for
// the rest along the normal: a start off the ray changes the distance of hits by up to h. If the
// moved start lies in a full voxel, such as an adjacent wall at a corner, the start moves along the
// normal alone. A point at height h and distance t along a ray with cosine c is t + h c from the
// surface's point, up to terms of h^2.
//
//     Perpendicular, c = 1: begins h along the ray. At 60 degrees off the normal, c = 1/2: h along
//         the ray, then h / 2 along the normal; begin = h + h / 4.
IndirectStart indirectStart(IndirectOrigin origin, vec3 way, vec3 going)
{
    float h = origin.lift, cosine = dot(way, origin.normal), aside = 1.0 - cosine;
    vec3 along = origin.place + h * going + aside * origin.up;
    bool within = voxelAt(along);
    return IndirectStart(within ? origin.place + origin.up : along, within ? h * cosine
        : h + h * aside * cosine, within && origin.full);
}

#ifdef INDIRECT_NEAR
// Screen-space hit within a ray's first voxels: the first sample behind the depth buffer. All
// samples are read, from the last on: drivers that run invocations in vectors gain nothing from an
// early exit. The homogeneous projection of samples is linear along the ray.
bool indirectShownNear(IndirectOrigin origin, vec3 way, float less, inout IndirectHit hit)
{
    bool flat_ = indirectIsOrthographic();
    float radius = indirect_reach.x, step_ = min(indirect_models.x, radius) / float(INDIRECT_STEPS),
        found = -1.0;
    vec3 going = indirectSeen(way, 0.0);
    for (int j = INDIRECT_STEPS; j >= 1; j--) {
        float s = step_ * (float(j) - less);
        vec3 seen = origin.seen + s * going;
        vec2 at = seen.xy / seen.z;
        bool shown = (flat_ || seen.z > indirect_view.x) && indirectIsShown(at);
        ivec2 pixel = shown ? ivec2(at) : ivec2(0);
        float depth = texelFetch(indirect_depth, pixel, 0).x;
        // distance behind the surface, multiplied by the depth in perspective
        float behind = flat_ ? (depth - 1.0) * indirect_view.x - origin.from.z - s * way.z
            : seen.z * depth - indirect_view.x;
        if (shown && depth > 0.0 && behind > 0.0 &&
            behind <= indirect_models.y * (flat_ ? 1.0 : depth)) {
            found = s;
            hit.pixel = pixel;
        }
    }
    if (found >= 0.0) hit.t = found / radius;
    return found >= 0.0;
}
#endif

// Finds the hit of a ray in voxels, and the cached radiance at the hit.
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
        RadianceRay ray = RadianceRay(origin.place, origin.place, voxelDirection(way),
            hit.t * indirect_reach.x, false);
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
    if (plane >= 0)
        return IndirectHit(far / indirect_reach.x, indirectShown(plane, origin.point + far * way),
            vec3(0.0));
#endif
    return hit;
}
