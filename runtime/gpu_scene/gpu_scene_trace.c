#include "runtime/gpu_scene/gpu_scene_trace.h"
#include "compiler/base/vec3.h"
#include "gen/render_text.h"
#include "runtime/gpu_scene/instances.h"
#include "runtime/gpu_scene/trace_text.h"
#include "runtime/displace/traced/displaced_traced.h"
#include <math.h>
#include <stdlib.h>

enum { MET_UNIT = MATERIAL_TEXTURES - 1 };

/* -- programs */

static bool make_program(Store *store, const GpuSceneSource *source, const PassProgram *program,
                         Material *made)
{
    GlContext *gl = store_context(store);
    char *text = trace_text(program->program, material_set_vertex(source->set, program),
                            material_set_fragment(source->set, program));
    if (!text)
        return gl_fail(gl, "out of memory");
    const ProgramText of = {.vertex = {"#version 450 core\n", render_text_trace_vertex},
                            .fragment = {text}};
    const bool fine = material_make(store, program->program, &of, made) ||
                      material_set_fail(gl, source->scene, program->material);
    free(text);
    if (fine)
        material_set_number(made, "trace_met", MET_UNIT);
    return fine;
}

bool gpu_scene_trace_make(Store *store, const GpuSceneSource *source, GpuScene *gpu_scene)
{
    if (!gpu_scene->instances || source->written || source->lines)
        return true;
    gpu_scene->traced = calloc((size_t)gpu_scene->kind_count + 1, sizeof *gpu_scene->traced);
    bool fine = gpu_scene->traced || gl_fail(store_context(store), "out of memory");
    for (int i = 0; fine && i < gpu_scene->place_count; i++) {
        const GpuScenePlace *place = &gpu_scene->places[i];
        if (place->transparent || !displaced_traced(&gpu_scene->displaced[place->mesh]))
            continue;
        const PassProgram *program = material_set_find(
            source->set, source->scene->objects[place->object].material, "gbuffer");
        gpu_scene->tracing = true;
        if (!gpu_scene->traced[place->kind].store)
            fine = make_program(store, source, program, &gpu_scene->traced[place->kind]);
    }
    for (int i = 0; fine && i < gpu_scene->mesh_count; i++)
        if (displaced_traced(&gpu_scene->displaced[i]))
            mesh_attach(store_context(store), &displaced_traced(&gpu_scene->displaced[i])->hulls,
                        gpu_scene->words);
    return fine;
}

void gpu_scene_trace_delete(GpuScene *gpu_scene)
{
    for (int i = 0; gpu_scene->traced && i < gpu_scene->kind_count; i++)
        material_delete(&gpu_scene->traced[i]);
    free(gpu_scene->traced);
}

void gpu_scene_trace_view(const GpuSceneSource *source, GpuScene *gpu_scene)
{
    for (int i = 0; gpu_scene->tracing && i < gpu_scene->kind_count; i++)
        if (gpu_scene->traced[i].store)
            spaces_set(&source->space->spaces, &gpu_scene->traced[i]);
}

bool gpu_scene_traces(const GpuScene *gpu_scene, const Drawable *drawable)
{
    return gpu_scene->tracing && gpu_scene->traced[drawable->kind].store &&
           displaced_traced(&gpu_scene->displaced[drawable->mesh]);
}

/* -- drawing */

static void begin(GlContext *gl, const GpuScene *gpu_scene, GLuint view)
{
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, INSTANCE_MATRICES, gpu_scene->matrices);
    gl->BindBufferBase(GL_UNIFORM_BUFFER, UNIFORMS_VIEW, view);
    gl->CullFace(GL_FRONT); /* a ray leaves a hull once, wherever it begins */
    gl->Enable(GL_DEPTH_CLAMP);
}

static void end(GlContext *gl)
{
    gl->FrontFace(GL_CCW);
    gl->CullFace(GL_BACK);
    gl->Disable(GL_CULL_FACE);
    gl->Disable(GL_DEPTH_CLAMP);
}

static void set(Material *material, const char *name, int components, const float *values)
{
    material_set(material, &(MaterialValue){name, components, values});
}

static void draw_hulls(GlContext *gl, const GpuScene *gpu_scene, int mesh, const int range[2])
{
    const DisplacedTrace *trace = displaced_traced(&gpu_scene->displaced[mesh]);
    displaced_traced_bind(&gpu_scene->displaced[mesh], &gpu_scene->meshes[mesh]);
    (trace->parallax ? gl->Disable : gl->Enable)(GL_CULL_FACE);
    mesh_draw_instances(gl, &trace->hulls, range[0], range[1]);
}

/* Computes the size of a pixel in clip space. */
static void find_pixel(const GpuSceneSource *source, float pixel[2])
{
    for (int i = 0; i < 2; i++)
        pixel[i] = 2 / (float)source->size[i];
}

/* Sets the mapping from the framebuffer's pixels to rays. */
static void set_pixels(Material *trace, const float pixel[2], const float corner[2])
{
    set(trace, "trace_pixel", 2, pixel);
    set(trace, "trace_corner", 2, corner);
}

void gpu_scene_trace_rays(GlContext *gl, const GpuSceneSource *source, GpuScene *gpu_scene)
{
    float pixel[2];
    find_pixel(source, pixel);
    const float corner[2] = {pixel[0] * (float)source->at[0] - 1,
                             pixel[1] * (float)source->at[1] - 1};
    begin(gl, gpu_scene, gpu_scene->views[0]);
    for (int i = 0; i < gpu_scene->opaque_count; i++) {
        const Drawable *drawable = &gpu_scene->surfaces[i];
        if (!drawable->seen || !gpu_scene_traces(gpu_scene, drawable))
            continue;
        Material *trace = &displaced_traced(&gpu_scene->displaced[drawable->mesh])->trace;
        set(trace, "trace_viewer", 4, source->space->spaces.viewer);
        set(trace, "trace_offset", 2, (float[]){0, 0});
        set_pixels(trace, pixel, corner);
        gl->FrontFace(drawable->mirrored ? GL_CW : GL_CCW);
        material_use(trace);
        draw_hulls(gl, gpu_scene, drawable->mesh, (int[]){drawable->first_seen, drawable->seen});
    }
    end(gl);
}

void gpu_scene_trace_surfaces(GlContext *gl, const GpuSceneSource *source, GpuScene *gpu_scene,
                              GLuint met)
{
    float pixel[2];
    find_pixel(source, pixel);
    begin(gl, gpu_scene, gpu_scene->views[0]);
    for (int i = 0; i < gpu_scene->opaque_count; i++) {
        const Drawable *drawable = &gpu_scene->surfaces[i];
        GpuSceneKind *kind = &gpu_scene->kinds[drawable->kind];
        if (!drawable->seen || !gpu_scene_traces(gpu_scene, drawable))
            continue;
        Material *material = &gpu_scene->traced[drawable->kind];
        const DisplacedTrace *trace = displaced_traced(&gpu_scene->displaced[drawable->mesh]);
        material_set_number(material, "trace_parts", (float)trace->parts);
        material_set_number(material, "trace_hull", (float)trace->triangles);
        material_set_number(material, "trace_turn", drawable->mirrored ? -1 : 1);
        set(material, "trace_viewer", 4, source->space->spaces.viewer);
        set(material, "trace_pixel", 2, pixel);
        gl->FrontFace(drawable->mirrored ? GL_CW : GL_CCW);
        material_use(material);
        texture_bind(gl, met, MET_UNIT);
        if (kind->numbers)
            gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, INSTANCE_NUMBERS, kind->numbers);
        draw_hulls(gl, gpu_scene, drawable->mesh, (int[]){drawable->first_seen, drawable->seen});
    }
    end(gl);
}

/* -- shadow maps */

/* Returns the determinant of three columns of rows x, y and w of a matrix. */
static double minor_of(const double m[16], int a, int b, int c)
{
    static const int rows[3] = {0, 1, 3};
    const int columns[3] = {a, b, c};
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        const double first = m[4 * columns[0] + rows[i]];
        sum +=
            first * (m[4 * columns[1] + rows[(i + 1) % 3]] * m[4 * columns[2] + rows[(i + 2) % 3]] -
                     m[4 * columns[1] + rows[(i + 2) % 3]] * m[4 * columns[2] + rows[(i + 1) % 3]]);
    }
    return sum;
}

/* Computes the point in which all rays of a view meet: w is 1. For parallel rays it is at
 * infinity: w is 0, and xyz the direction in which depth grows. */
static void find_viewer(const double m[16], float viewer[4])
{
    const double least = 1e-9;
    double at[4] = {minor_of(m, 1, 2, 3), -minor_of(m, 0, 2, 3), minor_of(m, 0, 1, 3),
                    -minor_of(m, 0, 1, 2)};
    const double size = vec3_length(at);
    const bool parallel = fabs(m[3]) + fabs(m[7]) + fabs(m[11]) < least * fabs(m[15]);
    const double deep = m[2] * at[0] + m[6] * at[1] + m[10] * at[2];
    const double scale = !parallel ? 1 / at[3] : (deep < 0 ? -1 : 1) / size;
    for (int i = 0; i < 4; i++)
        viewer[i] = parallel && i == 3 ? 0 : (float)(at[i] * scale);
}

void gpu_scene_trace_cast(GlContext *gl, GpuScene *gpu_scene, int mesh,
                          const GpuSceneTraceCast *cast)
{
    const GpuSceneLight *light = cast->light;
    Material *trace = &displaced_traced(&gpu_scene->displaced[mesh])->trace;
    float viewer[4];
    find_viewer(light->clip_from_world, viewer);
    set(trace, "trace_viewer", 4, viewer);
    set(trace, "trace_offset", 2, light->traced->offset);
    set_pixels(trace, light->traced->pixel, light->traced->corner);
    material_use(trace);
    begin(gl, gpu_scene, gpu_scene->views[1]);
    draw_hulls(gl, gpu_scene, mesh, (int[]){cast->first, cast->count});
    gl->CullFace(GL_BACK);
    gl->Disable(GL_CULL_FACE);
    gl->Disable(GL_DEPTH_CLAMP);
}
