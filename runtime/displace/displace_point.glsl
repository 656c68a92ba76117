// Displaces a point of a patch; shared by all stages that make triangles of patches.
// matc_displaced() precedes this text.

// Rows of four vec4: position and u, normal and v, dP/du, dP/dv. Patches of 12 row numbers: corners
// for shading, corners for displacement, and the ends of edges 0, 1 and 2 for displacement. Drawn
// patches: the patch, and the numbers of parts of its edges in bytes 0 to 2 and of its interior in
// byte 3.
layout(std430, binding = 6) readonly buffer DisplaceRows {
    vec4 displace_rows[];
};
layout(std430, binding = 7) readonly buffer DisplacePatches {
    uint displace_patches[];
};
layout(std430, binding = 8) readonly buffer DisplaceDrawn {
    uvec2 displace_drawn[];
};
uniform mat3 displace_localFromWorld;

uvec4 displaceParts(uint drawn)
{
    return uvec4(drawn, drawn >> 8, drawn >> 16, drawn >> 24) & 255u;
}

// Returns the barycentric weights of point number `point` on a triangular grid, whose row i has i +
// 1 points; their sum is `parts`.
ivec3 displaceRow(int point, int parts)
{
    int row = int((sqrt(float(8 * point + 1)) - 1.0) / 2.0);
    row += int((row + 1) * (row + 2) / 2 <= point) - int(row * (row + 1) / 2 > point);
    int i = point - row * (row + 1) / 2;
    return ivec3(parts - row, row - i, i);
}

// Snaps a point on an edge with fewer parts back to the last existing point: adjacent triangles
// become degenerate, and the points match the neighbor's.
ivec3 displaceFitted(ivec3 w, uint drawn, int all)
{
    for (int k = 0; k < 3; k++)
        if (w[k] == 0) {
            int parts = int(displaceParts(drawn)[k]);
            int at = w[(k + 1) % 3] * parts / all * all / parts;
            w[(k + 1) % 3] = at;
            w[(k + 2) % 3] = all - at;
        }
    return w;
}

// Interpolates three rows. If one weight is 0, the sum has two products, and is the same in either
// order.
vec4 displaceMixed(uvec3 rows, vec3 w, uint part)
{
    precise vec4 sum = displace_rows[4u * rows.x + part] * w.x +
        displace_rows[4u * rows.y + part] * w.y
                     + displace_rows[4u * rows.z + part] * w.z;
    return sum;
}

uvec3 displaceCorners(uint patchNumber)
{
    uint first = 12u * patchNumber;
    return uvec3(displace_patches[first], displace_patches[first + 1u],
        displace_patches[first + 2u]);
}

#ifdef DISPLACE_POINT
#ifndef DISPLACE_OUT
#define DISPLACE_OUT out
#endif
precise DISPLACE_OUT vec3 displaced_position;
DISPLACE_OUT vec3 displaced_normal;
DISPLACE_OUT vec2 displaced_texcoord;
DISPLACE_OUT vec3 displaced_tangentU, displaced_tangentV;
precise DISPLACE_OUT vec3 displaced_base;

// Returns the rows that determine the displacement of the point: equal for all vertices at the same
// position.
uvec3 displaceMoving(uint first, uvec3 own, vec3 w)
{
    for (int k = 0; k < 3; k++)
        if (w[k] == 1.0)
            return uvec3(displace_patches[first + 3u + uint(k)]);
    for (int k = 0; k < 3; k++)
        if (w[k] == 0.0) {
            uint edge = first + 6u + 2u * uint(k);
            own[(k + 1) % 3] = displace_patches[edge];
            own[(k + 2) % 3] = displace_patches[edge + 1u];
            return own;
        }
    return own;
}

uniform float displace_push, displace_bulge; // rounding of a hard-edged closed mesh; 0: none

// Returns the mean of the corners' normals, each the normalized sum over its adjacent triangles;
// and the offset that push and bulge give to the point p. Along an edge both depend on its two ends
// alone. A cube from -1 to 1: in the middle of a face the mean is 1 / sqrt(3) long, so a push of
// sqrt(3) is 0.73 there and 0 at corners: all points are sqrt(3) from the center.
vec3 displaceRounded(uint first, vec3 w, vec3 p, out vec3 mean)
{
    vec3 n[3], toward[3];
    for (int k = 0; k < 3; k++) {
        uint row = 4u * displace_patches[first + 3u + uint(k)];
        n[k] = displace_rows[row + 1u].xyz / max(length(displace_rows[row + 1u].xyz), 1e-30);
        toward[k] = dot(displace_rows[row].xyz - p, n[k]) * n[k];
    }
    precise vec3 sum = n[0] * w.x + n[1] * w.y + n[2] * w.z;
    precise vec3 tangent = toward[0] * w.x + toward[1] * w.y + toward[2] * w.z;
    float size = max(length(sum), 1e-30);
    mean = sum / size;
    return displace_push * (1.0 - size) * mean + displace_bulge * tangent;
}

uniform float displace_depth; // maximum displacement in world space

// Sets the captured outputs for the point with these weights, whose sum is 1; `lower`: for the
// point at the maximum depth below it, where a skirt ends.
void displaceAt(uint patchNumber, vec3 w, bool lower)
{
    uint first = 12u * patchNumber;
    uvec3 own = displaceCorners(patchNumber);
    uvec3 moving = displaceMoving(first, own, w);
    vec4 position = displaceMixed(own, w, 0u), normal = displaceMixed(own, w, 1u);
    vec4 along = displaceMixed(moving, w, 0u), up = displaceMixed(moving, w, 1u);
    displaced_base = position.xyz;
    displaced_normal = normal.xyz / max(length(normal.xyz), 1e-30);
    displaced_texcoord = vec2(position.w, normal.w);
    displaced_tangentU = displaceMixed(own, w, 2u).xyz;
    displaced_tangentV = displaceMixed(own, w, 3u).xyz;
    precise vec3 from = (matc_worldFromLocal * vec4(position.xyz, 1.0)).xyz;
    precise vec3 to = matc_displaced(position.xyz, up.xyz, vec2(along.w, up.w),
        displaceMixed(moving, w, 2u).xyz,
                                     displaceMixed(moving, w, 3u).xyz);
    vec3 away = matc_worldNormalFromLocal * up.xyz;
    if (lower)
        to = from - away * (displace_depth / max(length(away), 1e-30));
    displaced_position = position.xyz + displace_localFromWorld * (to - from);
    if (displace_push != 0.0 || displace_bulge != 0.0) {
        vec3 mean;
        displaced_position += displaceRounded(first, w, position.xyz, mean);
        displaced_normal = mean;
    }
}

void displacePoint(uint patchNumber, vec3 w)
{
    displaceAt(patchNumber, w, false);
}

#ifdef DISPLACE_VOLUME
// Returns the position over the point at one of a volume's four heights; `there` is false where its
// interval is empty.
vec3 displaceOver(uint patchNumber, vec3 w, int height, out bool there)
{
    uvec3 own = displaceCorners(patchNumber), moving = displaceMoving(12u * patchNumber, own, w);
    vec3 position = displaceMixed(own, w, 0u).xyz;
    vec4 along = displaceMixed(moving, w, 0u), up = displaceMixed(moving, w, 1u);
    vec4 solid = matc_solid(position, up.xyz, vec2(along.w, up.w), displaceMixed(moving, w, 2u).xyz,
        displaceMixed(moving, w, 3u).xyz);
    vec3 away = matc_worldNormalFromLocal * up.xyz;
    there = height < 2 ? solid.x < solid.y : solid.z < solid.w;
    return position + displace_localFromWorld * (away * (solid[height] / max(length(away), 1e-30)));
}

// Sets the captured outputs for that height; returns false if its interval is empty. The normal is
// perpendicular to the directions to two nearby points, which are on no edge, and points away from
// the solid.
bool displaceHeight(uint patchNumber, vec3 w, int height, float step)
{
    bool there, beside;
    displacePoint(patchNumber, w);
    displaced_position = displaceOver(patchNumber, w, height, there);
    vec3 across = cross(displaceOver(patchNumber, w + step * vec3(-1, 0.5, 0.5), height, beside) -
        displaced_position,
                        displaceOver(patchNumber, w + step * vec3(0.25, -1, 0.75), height, beside) -
                            displaced_position);
    float side = (dot(across, displaced_normal) < 0.0 ? -1.0 : 1.0) *
        (height % 2 == 0 ? -1.0 : 1.0);
    if (length(across) > 0.0)
        displaced_normal = side * across / length(across);
    return there;
}
#endif
#endif
