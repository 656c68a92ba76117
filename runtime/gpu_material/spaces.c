/* Sets the uniforms that are named after transforms. */
#include "runtime/gpu_material/spaces.h"

static void set(Material *material, const char *name, int components, const float *values)
{
    material_set(material, &(MaterialValue){name, components, values});
}

/* Clip space with depth from 0 to 1, like the depth buffer. If clip space depth starts at -1,
 * its rows are combined before they are multiplied by the view: these sums are exact. Afterwards
 * near would have been rounded together with the camera's distance from the origin. */
static Mat4 find_depth_from_world(const Spaces *spaces)
{
    Mat4 clip = spaces->clip_from_eye;
    for (int i = 0; i < 4 && !spaces->zero_to_one; i++)
        clip.m[4 * i + 2] = (clip.m[4 * i + 2] + clip.m[4 * i + 3]) / 2;
    return mat4_multiply(&clip, &spaces->eye_from_world);
}

static void set_plane(const Spaces *spaces, const Mat4 *depth_from_world, Material *material)
{
    float depth[4], w[4];
    for (int i = 0; i < 4; i++) { /* copies the rows of z and w */
        depth[i] = depth_from_world->m[4 * i + 2];
        w[i] = depth_from_world->m[4 * i + 3];
    }
    set(material, "matc_planeOrigin", 3, spaces->plane[0]);
    set(material, "matc_planeU", 3, spaces->plane[1]);
    set(material, "matc_planeV", 3, spaces->plane[2]);
    set(material, "matc_depthZ", 4, depth);
    set(material, "matc_clipW", 4, w);
}

/* Returns the matrix from which the vertex programs of planes and skies compute rays. With depth
 * from 0 to 1 in any clip space, a ray is a point at depth 0, at infinity, and not a difference
 * of points that are as far from the origin as the camera. Parallel rays end at the plane. */
static Mat4 find_world_from_clip(const Spaces *spaces, const Mat4 *depth_from_world)
{
    Mat4 result = mat4_identity();
    if (!spaces->parallel) {
        mat4_inverse(depth_from_world, &result);
        return result;
    }
    for (int i = 0; i < 3; i++) {
        result.m[i] = spaces->rays[2][i];
        result.m[4 + i] = spaces->rays[3][i];
        result.m[8 + i] = 0;
        result.m[12 + i] = spaces->rays[1][i];
    }
    result.m[11] = 1; /* the point is infinitely far ahead and has no position */
    result.m[15] = 0;
    return result;
}

static const char time_name[] = "matc_time";

bool spaces_by_time(const Material *material) { return material_has(material, time_name); }

void spaces_set(const Spaces *spaces, Material *material)
{
    const Mat4 clip_from_world = mat4_multiply(&spaces->clip_from_eye, &spaces->eye_from_world);
    const Mat3 eye_from_world = mat3_from_mat4(&spaces->eye_from_world);
    const Mat3 normal = mat3_normal(&spaces->world_from_local);
    /* a rotation is its own inverse transpose */
    const Mat3 eye_normal = mat3_multiply(&eye_from_world, &normal);
    const Mat4 depth_from_world = find_depth_from_world(spaces);
    const Mat4 world_from_clip = find_world_from_clip(spaces, &depth_from_world);
    set(material, "matc_worldFromLocal", 16, spaces->world_from_local.m);
    set(material, "matc_clipFromWorld", 16, clip_from_world.m);
    set(material, "matc_worldFromClip", 16, world_from_clip.m);
    set(material, "matc_worldNormalFromLocal", 9, normal.m);
    set(material, "matc_eyeNormalFromLocal", 9, eye_normal.m);
    set(material, "matc_eyeFromWorld", 9, eye_from_world.m);
    set(material, "matc_eyePosition", 3, spaces->parallel ? spaces->rays[0] : spaces->eye);
    set(material, "matc_viewer", 4, spaces->viewer);
    set(material, "matc_origin", 3, spaces->origin);
    set(material, time_name, 1, &spaces->time);
    set(material, "matc_object", 1, &spaces->object);
    set_plane(spaces, &depth_from_world, material);
}
