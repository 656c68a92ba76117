// What a ray meets by two models of the scene, each where it knows best. The picture knows surfaces to the pixel, but only what it shows; voxels know what is hidden
// and beside it, but nothing finer than themselves, and rays begin a little off. So the picture is asked for the ray's first voxels, and takes part only where its depth is
// conclusive: a place that lies behind what is shown by no more than indirect_models.y is in it; farther behind, one cannot know. All else voxels decide.
//
// A hit of the picture sends the light of its pixel, one of voxels cached radiance: that is nearer to what paths of light give than pixels that show something close to
// the hit, and does not change with the camera.

// Where a ray goes on in voxels: off the surface, where voxelStart says.
struct IndirectStart {
    vec3 place;  // in the grid's units
    float begin; // where the ray is then
};

// Off the surface by h, but along the ray, as far as h may take it, and only for the rest along the normal: of what is met from a place beside the ray, the distance is another, up
// to h. Along the ray it must not get into what stands beside the point, a wall at a corner: then it is along the normal alone. What is at a place h off along the normal,
// t along a way with a cosine of c, is as far from the point as t + h c along it, but for terms of h^2.
//
//     straight up, c = 1: begins h along the ray; at 60 degrees off the normal, c = 1/2: h along the ray, then h / 2 along the normal, begin = h + h / 4
IndirectStart indirectStart(vec3 point, vec3 normal, vec3 way)
{
    vec3 place = voxelPlace(point), up = voxelDirection(normal);
    float size = length(up), cosine = dot(way, normal), h = distance(voxelStart(place, up / size), place) / size;
    float aside = h - h * cosine;
    vec3 along = place + voxelDirection(h * way + aside * normal);
    if (voxelAt(along)) return IndirectStart(place + h * up, h * cosine);
    return IndirectStart(along, h + aside * cosine);
}

#ifdef INDIRECT_RADIANCE
// What is sent from the end of a ray; where a pixel shows that: of bounces behind the first.
vec3 indirectCached(vec3 point, vec3 normal, IndirectHit hit, vec3 way)
{
    float far = hit.t * indirect_reach.x;
    vec3 place = voxelPlace(point);
    IndirectStart start = IndirectStart(place, 0.0);
    bool shown = hit.pixel.x >= 0;
    if (hit.pixel.x < -1 || (shown && RADIANCE_TEXELS < 3)) return vec3(0.0);
    if (!shown) start = indirectStart(point, normal, way);
    RadianceSum sum = radianceAlong(place, start.place, voxelDirection(way), far - start.begin);
    return (shown ? sum.further : sum.direct + sum.further) / max(sum.weight, 1e-6);
}
#endif

// What it meets in voxels.
IndirectHit indirectVoxel(vec3 point, vec3 normal, vec3 way)
{
    float t, radius = indirect_reach.x;
    ivec2 pixel = ivec2(-1);
    IndirectStart start = indirectStart(point, normal, way);
#ifdef INDIRECT_RADIANCE
    if (radianceBegins(voxelPlace(point), start.place, voxelDirection(way))) return IndirectHit(start.begin / radius, pixel);
#endif
    if (!voxelRay(start.place, voxelDirection(way), radius - start.begin, t)) return IndirectHit(-1.0, pixel);
    return IndirectHit((t + start.begin) / radius, pixel);
}

IndirectHit indirectMeet(vec3 point, vec3 normal, vec3 way, float less)
{
    float radius = indirect_reach.x;
#ifdef INDIRECT_NEAR
    float near = min(indirect_models.x, radius);
    vec3 from = point + (indirect_reach.y + indirect_reach.z * indirectPixelSize(point)) * normal;
    for (int j = 1; j <= INDIRECT_STEPS; j++) {
        float s = near * (float(j) - less) / float(INDIRECT_STEPS);
        vec3 place = from + s * way;
        vec2 at = indirectPlace(place);
        if ((!indirectIsOrthographic() && -place.z <= indirect_view.x) || any(lessThan(at, vec2(0.0))) ||
            any(greaterThanEqual(at, indirect_picture.xy)))
            break;
        float depth = texelFetch(indirect_depth, ivec2(at), 0).x;
        if (depth <= 0.0 || !indirectIsBehind(place, depth)) continue;
        if (indirectPoint(ivec2(at), depth).z - place.z <= indirect_models.y) return IndirectHit(s / radius, ivec2(at));
    }
#endif
    IndirectHit hit = indirectVoxel(point, normal, way);
#ifdef INDIRECT_PLANES
    float far = hit.t < 0.0 ? radius : min(hit.t * radius, radius);
    int plane = indirectPlane(point, way, far);
    if (plane >= 0) return IndirectHit(far / radius, indirectShown(plane, point + far * way));
#endif
    return hit;
}
