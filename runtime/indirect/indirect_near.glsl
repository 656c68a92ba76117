// What a ray meets by two models of the scene, each where it knows best. The picture knows surfaces to the pixel, but only what it shows; voxels know what is hidden
// and beside it, but nothing finer than themselves, and rays begin a little off. So the picture is asked for the ray's first voxels, and takes part only where its depth is
// conclusive: a place that lies behind what is shown by no more than indirect_models.y is in it; farther behind, one cannot know. All else voxels decide.
//
// A hit of the picture sends the light of its pixel, one of voxels cached radiance: that is nearer to what paths of light give than pixels that show something close to
// the hit, and does not change with the camera.

// What all rays of a point have in common.
struct IndirectOrigin {
    vec3 point, normal, from; // from: a little off the surface, where what the picture shows is asked from
    vec3 place, up;           // of the grid's units: the point; from there to where voxelStart says
    float lift;               // the length of `up`, in the eye's units
};

IndirectOrigin indirectOrigin(vec3 point, vec3 normal)
{
    vec3 place = voxelPlace(point), along = voxelDirection(normal);
    float size = length(along);
    vec3 up = voxelStart(vec3(0.0), along / size);
    return IndirectOrigin(point, normal, point + (indirect_reach.y + indirect_reach.z * indirectPixelSize(point)) * normal, place, up,
                          length(up) / size);
}

// Where a ray goes on in voxels: off the surface, where voxelStart says.
struct IndirectStart {
    vec3 place;  // in the grid's units
    float begin; // where the ray is then
    bool full;   // in a full voxel, as in a corner
};

// Off the surface by h, but along the ray, as far as h may take it, and only for the rest along the normal: of what is met from a place beside the ray, the distance is another, up
// to h. Along the ray it must not get into what stands beside the point, a wall at a corner: then it is along the normal alone. What is at a place h off along the normal,
// t along a way with a cosine of c, is as far from the point as t + h c along it, but for terms of h^2.
//
//     straight up, c = 1: begins h along the ray; at 60 degrees off the normal, c = 1/2: h along the ray, then h / 2 along the normal, begin = h + h / 4
IndirectStart indirectStart(IndirectOrigin origin, vec3 way, vec3 going)
{
    float h = origin.lift, cosine = dot(way, origin.normal), aside = 1.0 - cosine;
    vec3 along = origin.place + h * going + aside * origin.up;
    if (voxelAt(along)) return IndirectStart(origin.place + origin.up, h * cosine, voxelAt(origin.place + origin.up));
    return IndirectStart(along, h + h * aside * cosine, false);
}

#ifdef INDIRECT_NEAR
// What the picture shows of a ray's first voxels. Where its places are seen, times their distance, goes on evenly along it.
bool indirectShownNear(IndirectOrigin origin, vec3 way, float less, inout IndirectHit hit)
{
    bool flat_ = indirectIsOrthographic();
    float radius = indirect_reach.x, step_ = min(indirect_models.x, radius) / float(INDIRECT_STEPS);
    vec2 scale = 0.5 / indirect_ray.xy, middle = 0.5 * indirect_ray.zw;
    for (int j = 1; j <= INDIRECT_STEPS; j++) {
        float s = step_ * (float(j) - less);
        vec3 place = origin.from + s * way;
        vec2 at = place.xy * (flat_ ? scale : scale / -place.z) + middle;
        if ((!flat_ && -place.z <= indirect_view.x) || !indirectIsShown(at)) break;
        float depth = texelFetch(indirect_depth, ivec2(at), 0).x;
        float behind = (flat_ ? (depth - 1.0) * indirect_view.x : -indirect_view.x / max(depth, 1e-30)) - place.z;
        if (depth <= 0.0 || behind <= 0.0 || behind > indirect_models.y) continue;
        hit.t = s / radius;
        hit.pixel = ivec2(at);
        return true;
    }
    return false;
}
#endif

// What it meets in voxels, and what is sent from there.
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
