/* Resources of the radiance cache: programs of materials that write nodes, buffers, and inputs
 * of the passes that read it. */
#include "runtime/indirect/radiance/radiance.h"
#include "gen/render_text.h"
#include "runtime/frame_graph/transparency_draw.h"
#include "runtime/indirect/settings/indirect.h"
#include "runtime/indirect/voxels/voxels.h"
#include "runtime/light/lighting.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FLOATS = 4, BOUNCED_TEXELS = 4, ONCE_TEXELS = 2 };

/* Reports whether any node can send light: reflected from lamps, or emitted. */
static bool is_lit(const Scene *scene)
{
    bool is = (scene_models(scene) & MODEL_EMITS) != 0;
    for (int i = 0; i < scene->light_count; i++)
        is |= view_space_section(&scene->lights[i], false) < VIEW_SPACE_SECTIONS;
    return is;
}

bool radiance_needed(const Renderer *renderer)
{
    return indirect_reads_radiance(renderer) && renderer->scene->indirect.bounces > 0 &&
           !indirect_shows(renderer, "bent") && !indirect_shows(renderer, "ao") &&
           !indirect_shows(renderer, "visibility") && is_lit(renderer->scene);
}

int radiance_texels(const Renderer *renderer)
{
    return renderer->scene->indirect.bounces > 1 ? BOUNCED_TEXELS : ONCE_TEXELS;
}

/* -- programs */

/* Makes one program for each surface kind that fills voxels. */
static bool make_keepers(Renderer *renderer)
{
    const GpuScene *gpu_scene = &renderer->gpu_scene;
    const MaterialSet *set = &renderer->set;
    FrameRadiance *radiance = renderer->radiance;
    TransparencyText *around = malloc(sizeof *around);
    bool fine = around != NULL;
    radiance->keeper_count = gpu_scene->kind_count;
    radiance->keepers = calloc((size_t)gpu_scene->kind_count + 1, sizeof *radiance->keepers);
    if (!fine || !radiance->keepers)
        return free(around), gl_fail(renderer->gl, "out of memory");
    transparency_text(renderer->gl, set, TRANSPARENCY_lists, around);
    around->body = render_text_radiance_store;
    for (int i = 0; fine && i < gpu_scene->place_count; i++) {
        const GpuScenePlace *place = &gpu_scene->places[i];
        const int material = renderer->scene->objects[place->object].material;
        const PassProgram *program = material_set_find(set, material, "gbuffer");
        if (!voxels_have(place) || radiance->keepers[place->kind].store)
            continue;
        ProgramText text = {.vertex = {material_set_vertex(set, program)},
                            .fragment = {material_set_fragment(set, program)}};
        transparency_wrap(around, false, &text);
        fine = material_make(renderer->store, program->program, &text,
                             &radiance->keepers[place->kind]) ||
               material_set_fail(renderer->gl, renderer->scene, material);
    }
    free(around);
    return fine;
}

static bool make_number(Renderer *renderer)
{
    const bool modern = renderer->gl->major * 10 + renderer->gl->minor >= 45;
    const ProgramText text = {.compute = {modern ? "#version 450 core\n" : "#version 430 core\n",
                                          render_text_radiance_number}};
    if (!material_make(renderer->store, NULL, &text, &renderer->radiance->number))
        return false;
    material_set_number(&renderer->radiance->number, "radiance_stride",
                        (float)transparency_stride(&renderer->set));
    return true;
}

void radiance_define(const Renderer *renderer, char text[RADIANCE_DEFINITIONS])
{
    snprintf(text, RADIANCE_DEFINITIONS,
             "#define RADIANCE_HEAD %d\n#define RADIANCE_TEXELS %d\n#define INDIRECT_RADIANCE\n",
             RADIANCE_HEAD, radiance_texels(renderer));
}

static bool make_light(Renderer *renderer)
{
    char reader[TRANSPARENCY_TEXT], defined[RADIANCE_DEFINITIONS];
    transparency_reader(&renderer->set, reader);
    radiance_define(renderer, defined);
    const LightingText text = {.body = {reader, defined, render_text_voxel_map,
                                        render_text_radiance_place, render_text_radiance_light},
                               .block = 64,
                               .of = LIGHTING_nodes};
    return lighting_make(renderer, &text, &renderer->radiance->light);
}

static bool make_bounce(Renderer *renderer)
{
    ScreenPass *bounce = &renderer->radiance->bounce;
    char defined[RADIANCE_DEFINITIONS], strides[RADIANCE_DEFINITIONS];
    radiance_define(renderer, defined);
    snprintf(strides, sizeof strides, "#define LISTS_STRIDE %du\n#define RADIANCE_RAYS %d\n",
             transparency_stride(&renderer->set), renderer->scene->indirect.rays);
    const ScreenPassText text = {.body = {defined, strides, render_text_voxel_map,
                                          render_text_voxel_ray, render_text_radiance,
                                          render_text_radiance_place, render_text_indirect_basis,
                                          render_text_radiance_bounce},
                                 .format = "RGBA16F",
                                 .compute = true,
                                 .block = 64};
    return renderer->scene->indirect.bounces < 2 ||
           screen_pass_make(renderer->store, &text, bounce);
}

/* -- buffers */

static void fill(const GlContext *gl, GLuint buffer, size_t bytes)
{
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
    gl->BufferData(GL_SHADER_STORAGE_BUFFER, (GLsizeiptr)bytes, NULL, GL_DYNAMIC_COPY);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
}

static void make_texture(const GlContext *gl, GLenum format, GLuint buffer, GLuint *made)
{
    if (!*made)
        gl->GenTextures(1, made);
    gl->BindTexture(GL_TEXTURE_BUFFER, *made);
    gl->TexBuffer(GL_TEXTURE_BUFFER, format, buffer);
}

/* The driver limits both the buffer's size and that of a texture on it. */
bool radiance_make_capacity(Renderer *renderer, GLuint nodes)
{
    const size_t texels = (size_t)nodes * (size_t)radiance_texels(renderer),
                 floats = texels * FLOATS;
    const size_t words = (size_t)nodes * (size_t)transparency_stride(&renderer->set);
    const size_t most = transparency_most_bytes(renderer);
    FrameRadiance *radiance = renderer->radiance;
    GLint texels_most = 0;
    renderer->gl->GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels_most);
    if (floats * sizeof(float) > most || words * sizeof(GLuint) > most ||
        texels > (size_t)texels_most)
        return false;
    fill(renderer->gl, radiance->nodes, words * sizeof(GLuint));
    fill(renderer->gl, radiance->kept, floats * sizeof(float));
    make_texture(renderer->gl, GL_RGBA32F, radiance->kept, &radiance->kept_texels);
    radiance->capacity = nodes;
    return true;
}

static bool make_buffers(Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    FrameRadiance *radiance = renderer->radiance;
    const size_t size =
        (size_t)(renderer->voxels->grid.size < RADIANCE_SIZE_MAX ? renderer->voxels->grid.size
                                                                 : RADIANCE_SIZE_MAX);
    radiance->size = (int)size;
    gl->GenBuffers(1, &radiance->faces);
    gl->GenBuffers(1, &radiance->nodes);
    gl->GenBuffers(1, &radiance->kept);
    gl->GenFramebuffers(1, &radiance->framebuffer);
    fill(gl, radiance->faces, (RADIANCE_HEAD + size * size * size) * sizeof(GLuint));
    make_texture(gl, GL_R32UI, radiance->faces, &radiance->faces_words);
    radiance_make_capacity(renderer, (GLuint)(RADIANCE_SIDES * size * size));
    return gl_check(renderer->gl, "making room for cached radiance");
}

void radiance_sort(Renderer *renderer)
{
    const GpuScene *gpu_scene = &renderer->gpu_scene;
    for (int i = 0; i < gpu_scene->place_count; i++) {
        const bool closed = gpu_scene->meshes[gpu_scene->places[i].mesh].body == SHAPE_BODY_solid &&
                            gpu_scene->places[i].cut < 0;
        renderer->radiance->casts[i] = voxel_bodies_is_body(renderer->voxels, i) ? RADIANCE_body
                                       : closed                                  ? RADIANCE_closed
                                                                                 : RADIANCE_surface;
    }
}

bool radiance_make(Renderer *renderer)
{
    renderer->radiance->casts =
        calloc((size_t)renderer->gpu_scene.place_count + 1, sizeof *renderer->radiance->casts);
    if (!renderer->radiance->casts)
        return gl_fail(renderer->gl, "out of memory");
    return make_buffers(renderer) && make_keepers(renderer) && make_number(renderer) &&
           make_light(renderer) && make_bounce(renderer);
}

/* -- inputs of passes that read the radiance cache */

void radiance_set(const Renderer *renderer, int unit, ScreenPass *pass)
{
    int shift = 0;
    while (renderer->voxels->grid.size >> shift > renderer->radiance->size)
        shift++;
    screen_pass_sampler(pass, "radiance_faces", unit);
    screen_pass_sampler(pass, "radiance_kept", unit + 1);
    material_set_number(&pass->material, "radiance_size", (float)renderer->radiance->size);
    material_set_number(&pass->material, "radiance_shift", (float)shift);
}

void radiance_bind(const Renderer *renderer, int unit)
{
    const GLuint textures[RADIANCE_UNITS] = {renderer->radiance->faces_words,
                                             renderer->radiance->kept_texels};
    for (int i = 0; i < RADIANCE_UNITS; i++) {
        renderer->gl->ActiveTexture(GL_TEXTURE0 + (GLenum)(unit + i));
        renderer->gl->BindTexture(GL_TEXTURE_BUFFER, textures[i]);
    }
}

bool radiance_param(Renderer *renderer, int material, const MaterialValue *value)
{
    const GpuScene *gpu_scene = &renderer->gpu_scene;
    bool found = false;
    for (int i = 0; i < gpu_scene->place_count && renderer->radiance->keepers; i++)
        if (renderer->scene->objects[gpu_scene->places[i].object].material == material &&
            renderer->radiance->keepers[gpu_scene->places[i].kind].store)
            found |= material_set(&renderer->radiance->keepers[gpu_scene->places[i].kind], value);
    renderer->radiance->drawn = false;
    return found;
}

bool radiance_by_time(const Renderer *renderer)
{
    const FrameRadiance *radiance = renderer->radiance;
    bool is = false;
    for (int i = 0; i < radiance->keeper_count; i++)
        is |= radiance->keepers[i].store && spaces_by_time(&radiance->keepers[i]);
    return is;
}

void radiance_put(Text *out, const Renderer *renderer)
{
    const FrameRadiance *radiance = renderer->radiance;
    const unsigned long each = sizeof(GLuint) * (unsigned long)transparency_stride(&renderer->set) +
                               sizeof(float) * FLOATS * (unsigned long)radiance_texels(renderer);
    if (radiance->count)
        text_format(out, "radiance  %lu nodes of %lu bytes, in %d x %d x %d voxels of %lu\n",
                    (unsigned long)radiance->count, each, radiance->size, radiance->size,
                    radiance->size, (unsigned long)sizeof(GLuint));
}

void radiance_delete(Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    FrameRadiance *radiance = renderer->radiance;
    const GLuint buffers[] = {radiance->faces, radiance->nodes, radiance->kept};
    const GLuint textures[] = {radiance->faces_words, radiance->kept_texels};
    for (int i = 0; i < radiance->keeper_count; i++)
        if (radiance->keepers[i].store)
            material_delete(&radiance->keepers[i]);
    free(radiance->keepers);
    free(radiance->casts);
    if (radiance->number.store)
        material_delete(&radiance->number);
    screen_pass_delete(&radiance->light);
    screen_pass_delete(&radiance->bounce);
    gl->DeleteTextures(sizeof textures / sizeof *textures, textures); /* GL ignores the name 0 */
    gl->DeleteBuffers(sizeof buffers / sizeof *buffers, buffers);
    gl->DeleteFramebuffers(1, &radiance->framebuffer);
    *radiance = (FrameRadiance){0};
}
