// The view visibility: surfaces visible from the point at the picture's center (Thiedemann 2009,
// 4.5), by rays of the method in use. White: visible; blue: occluded, or one of the surfaces faces
// away; gray: farther than the ray length. Red marks the center itself. A hit within a step of the
// ray's end, two voxels or one marching step, counts as the end.
vec4 passPixel(ivec2 pixel)
{
    ivec2 middle = ivec2(indirect_picture.xy) / 2;
    float depth = texelFetch(indirect_depth, pixel, 0).x,
        there = texelFetch(indirect_depth, middle, 0).x;
    if (depth <= 0.0) return vec4(0.0, 0.0, 0.0, 1.0);
    if (all(lessThan(abs(pixel - middle), ivec2(3)))) return vec4(1.0, 0.0, 0.0, 1.0);
    vec3 point = indirectPoint(pixel, depth), normal = indirectNormal(pixel);
    float shade = 0.3 +
        0.7 * abs(dot(normal, indirectIsOrthographic() ? vec3(0.0, 0.0, 1.0) : normalize(point)));
    if (there <= 0.0) return vec4(vec3(0.5 * shade), 1.0);
    vec3 from = indirectPoint(middle, there), own = indirectNormal(middle), way = point - from;
    float far = length(way), radius = indirect_reach.x;
    way /= max(far, 1e-30);
    if (far > radius) return vec4(vec3(0.5 * shade), 1.0);
    bool seen = dot(own, way) > 0.0 && dot(normal, way) < 0.0;
    if (seen) {
        IndirectHit hit = indirectMeet(indirectOrigin(from, own), way, 0.0);
        float step_ = 0.5 * indirect_models.x;
#ifndef INDIRECT_LEVELS
        step_ = max(step_, radius / float(INDIRECT_STEPS));
#endif
        seen = hit.t < 0.0 || hit.t * radius > far - step_ / max(-dot(normal, way), 0.2);
    }
    return vec4(shade * (seen ? vec3(1.0) : vec3(0.1, 0.2, 0.6)), 1.0);
}
