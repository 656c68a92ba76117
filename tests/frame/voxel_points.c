#include "gen/render_text.h"
#include "runtime/indirect/voxels/voxels.h"
#include "tests/frame/voxel_points.h"
#include "tests/vectors.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

const char voxel_points_ray[] =
    "bool pointRay(vec3 from, vec3 way, float far, out float count)\n{\n"
    "    VoxelMeeting meeting;\n"
    "    bool met = voxelMeets(from, way, far, meeting);\n"
    "    count = float(meeting.bricks);\n    return met;\n}\n";

static const char body[] =
    "uniform sampler2D points, directions;\nuniform float radius, off;\n"
    "vec4 pointTexel(ivec2 pixel, int i) { return texelFetch(points, ivec2(4 * pixel.x + i, "
    "pixel.y), 0); }\n"
    "vec4 passPixel(ivec2 pixel)\n{\n"
    "    vec4 place = pointTexel(pixel, 0);\n    vec3 normal = pointTexel(pixel, 3).xyz;\n    vec2 "
    "sum = vec2(0.0);\n"
    "    int count = textureSize(directions, 0).x;\n"
    "    vec3 from = off > 0.0 ? place.xyz + off * normal : voxelStart(place.xyz, normal), u = "
    "pointTexel(pixel, "
    "1).xyz;\n"
    "    if (place.w == 0.0) return vec4(0.0);\n"
    "    for (int i = 0; i < count; i++) {\n"
    "        vec3 d = texelFetch(directions, ivec2(i, 0), 0).xyz;\n        float taken;\n"
    "        bool met = pointRay(from, d.x * u + d.y * pointTexel(pixel, 2).xyz + d.z * normal, "
    "radius, taken);\n"
    "        sum += vec2(met ? 0.0 : 1.0, taken);\n    }\n"
    "    return vec4(sum / float(count), 0.0, 0.0);\n}\n";

bool voxel_points_make(int wide, int high, int across, VoxelPoints *made)
{
    uint32_t state = 5;
    *made = (VoxelPoints){.wide = wide, .high = high, .rays = across * across};
    made->texels = calloc((size_t)wide * (size_t)high, sizeof *made->texels);
    made->directions = calloc((size_t)made->rays, sizeof *made->directions);
    for (int i = 0; made->directions && i < made->rays; i++) {
        double place[2];
        for (int k = 0; k < 2; k++) {
            state = state * 1664525u + 1013904223u;
            place[k] = ((k ? i / across : i % across) + (state >> 8) / 16777216.) / across;
        }
        const double r = sqrt(place[0]), turn = 2 * 3.14159265358979323846 * place[1];
        made->directions[i][0] = (float)(r * cos(turn));
        made->directions[i][1] = (float)(r * sin(turn));
        made->directions[i][2] = (float)sqrt(1 - place[0]);
    }
    return made->texels && made->directions;
}

void voxel_points_set(const VoxelPoints *points, int number, const VoxelGrid *grid,
                      const double world[3], const double normal[3])
{
    float(*texels)[4] = points->texels[number];
    double aside[3] = {0}, u[3], v[3];
    aside[fabs(normal[0]) < .6 ? 0 : 1] = 1;
    cross(normal, aside, u);
    const double length = sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    for (int k = 0; k < 3; k++)
        u[k] /= length;
    cross(normal, u, v);
    for (int k = 0; k < 3; k++) {
        texels[0][k] = (float)((world[k] - grid->low[k]) / grid->edge);
        texels[1][k] = (float)u[k];
        texels[2][k] = (float)v[k];
        texels[3][k] = (float)normal[k];
    }
    texels[0][3] = 1;
}

void voxel_points_free(VoxelPoints *points)
{
    free(points->texels);
    free(points->directions);
    *points = (VoxelPoints){.wide = 0};
}

bool voxel_points_open(const Renderer *renderer, const VoxelPoints *points,
                       const char *const glsl[2], VoxelPointsPass *made)
{
    GlContext *gl = renderer->gl;
    const FramebufferSpec spec = {.width = points->wide,
                                  .height = points->high,
                                  .color_count = 1,
                                  .color_format = GL_RGBA32F};
    const TextureSpec specs[2] = {
        {.width = VOXEL_POINTS_TEXELS * points->wide,
         .height = points->high,
         .components = 4,
         .floats = points->texels[0][0]},
        {.width = points->rays, .height = 1, .components = 4, .floats = points->directions[0]}};
    ScreenPassText text = {.body = {render_text_voxel_map, render_text_voxel_ray},
                           .format = "RGBA32F",
                           .compute = true};
    int count = 2;
    for (int i = 0; i < 2; i++)
        if (glsl[i])
            text.body[count++] = glsl[i];
    text.body[count] = body;
    *made = (VoxelPointsPass){.textures = {0}};
    gl->ActiveTexture(GL_TEXTURE0);
    for (int i = 0; i < 2; i++)
        if (!(made->textures[i] = texture_make(gl, &specs[i])))
            return false;
    if (!framebuffer_make(gl, &spec, &made->target) ||
        !screen_pass_make(renderer->store, &text, &made->pass))
        return false;
    screen_pass_sampler(&made->pass, "points", 0);
    screen_pass_sampler(&made->pass, "directions", 1);
    return true;
}

void voxel_points_run(const Renderer *renderer, VoxelPointsPass *pass, float radius, float off)
{
    for (int i = 0; i < 2; i++)
        texture_bind(renderer->gl, pass->textures[i], i);
    pass_voxels_set(renderer, 2, &pass->pass);
    voxel_bricks_bind(renderer, 2);
    screen_pass_sampler(&pass->pass, "voxel_slices", 3);
    renderer->gl->ActiveTexture(GL_TEXTURE0 + 3);
    renderer->gl->BindTexture(GL_TEXTURE_2D_ARRAY, renderer->voxels->map);
    material_set_number(&pass->pass.material, "off", off);
    material_set_number(&pass->pass.material, "radius", radius);
    screen_pass_run(&pass->pass, &pass->target, &renderer->screen);
}

void voxel_points_close(const Renderer *renderer, VoxelPointsPass *pass)
{
    screen_pass_delete(&pass->pass);
    framebuffer_delete(renderer->gl, &pass->target);
    renderer->gl->DeleteTextures(2, pass->textures); /* GL ignores the name 0 */
    *pass = (VoxelPointsPass){.textures = {0}};
}
