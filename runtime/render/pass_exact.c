/* The pass exact: which triangle each pixel sees; and what exact shadows read, made once for a scene: the triangles of all that is opaque, and the
 * lists of exact_lists.h. exact.glsl says what becomes of them. */
#include "runtime/render/frame.h"
#include <stdlib.h>
#include <string.h>

extern const char render_text_exact[], render_text_exact_seen[], render_text_exact_vertex[],
    render_text_exact_fragment[];

enum { TRIANGLES_BINDING = 6, LISTS_BINDING = 7 };

static bool has_lights(const Render *render)
{
    bool has = false;
    for (int i = 0; i < render->scene->light_count; i++)
        has |= exact_lists_wanted(&render->scene->lights[i]);
    return has && !render->options.no_shadows;
}

/* Opaque places come first. */
bool pass_exact_needed(const Render *render)
{
    return render->cache.place_count > 0 && !render->cache.places[0].transparent && has_lights(render);
}

/* -- buffers */

static size_t corner_bytes(int count) { return (size_t)count * sizeof(ExactCorners); }

/* Corners of objects range[0] to range[1] - 1, into a buffer that has room for all, or is made. */
static bool write_corners(Render *render, const int range[2])
{
    const GlContext *gl = render->gl;
    ExactShadows *exact = &render->exact;
    const ExactTriangles *triangles = &exact->triangles;
    const ExactObject *first = &triangles->objects[range[0]], *last = &triangles->objects[range[1] - 1];
    const int count = last->first + last->count - first->first;
    ExactCorners *corners = malloc(corner_bytes(count) + 1);
    if (!corners || !exact_triangles_corners(render->scene, &render->cache, triangles, range, corners))
        return free(corners), gl_fail(render->gl, "out of memory");
    gl->BindBuffer(GL_ARRAY_BUFFER, exact->corners);
    if (count == triangles->count)
        gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)corner_bytes(count), corners, GL_DYNAMIC_DRAW);
    else
        gl->BufferSubData(GL_ARRAY_BUFFER, (GLintptr)corner_bytes(first->first), (GLsizeiptr)corner_bytes(count),
                          corners);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
    free(corners);
    return gl_check(render->gl, "making room for exact shadows");
}

static bool measure(Render *render)
{
    const size_t most = transparency_most_bytes(render);
    ExactTriangles *triangles = &render->exact.triangles;
    exact_triangles_free(triangles);
    if (!exact_triangles_make(render->scene, &render->cache, triangles))
        return gl_fail(render->gl, "out of memory");
    return corner_bytes(triangles->count) <= most ||
           gl_fail(render->gl, "shadows: exact takes %lu bytes in a buffer, and there may be %lu",
                   (unsigned long)corner_bytes(triangles->count), (unsigned long)most);
}

static bool write_triangles(Render *render)
{
    return measure(render) && write_corners(render, (int[]){0, render->exact.triangles.object_count});
}

bool pass_exact_list(Render *render)
{
    ExactShadows *exact = &render->exact;
    return exact_cover_make(&exact->cover, render->scene, &exact->triangles, exact->corners);
}

/* -- which triangle is seen */

/* Clip space from where corners are counted from: a product in double, of a matrix that the driver has in floats. */
static void set_clip(Render *render)
{
    const float *clip = render->space.spaces.clip_from_eye.m;
    const double *eye = render->space.eye_from_world, *origin = render->exact.triangles.origin;
    double moved[16];
    float product[16];
    for (int i = 0; i < 16; i++)
        moved[i] = i < 12 ? eye[i] : eye[i - 12] * origin[0] + eye[i - 8] * origin[1] + eye[i - 4] * origin[2] + eye[i];
    for (int i = 0; i < 16; i++) {
        double sum = 0;
        for (int k = 0; k < 4; k++)
            sum += (double)clip[4 * k + i % 4] * moved[i / 4 * 4 + k];
        product[i] = (float)sum;
    }
    material_set(&render->exact.material, &(MaterialValue){"exact_clip", 16, product});
}

static bool make_program(Render *render)
{
    const bool newest = render->gl->major * 10 + render->gl->minor >= 45;
    const char *head = newest ? "#version 450 core\n" : "#version 430 core\n";
    const ProgramText text = {.vertex = {head, render_text_exact_vertex},
                              .fragment = {head, render_text_exact_fragment}};
    return render->exact.material.store || material_make(render->store, NULL, &text, &render->exact.material);
}

static void make_array(Render *render)
{
    const GlContext *gl = render->gl;
    gl->GenVertexArrays(1, &render->exact.array);
    gl->BindVertexArray(render->exact.array);
    gl->BindBuffer(GL_ARRAY_BUFFER, render->exact.corners);
    gl->EnableVertexAttribArray(0);
    gl->VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 3 * sizeof(float), NULL);
    gl->BindVertexArray(0);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
}

/* Its programs stay for the next scene. */
static bool open_cover(Render *render)
{
    const size_t most = transparency_most_bytes(render) / sizeof(GLuint);
    return render->exact.cover.cover.store || exact_cover_open(render->store, most, &render->exact.cover);
}

bool pass_exact_make(Render *render)
{
    ExactShadows *exact = &render->exact;
    if (!transparency_has_lists(render->gl))
        return gl_fail(render->gl, "shadows: exact takes OpenGL 4.3, and the driver has %d.%d", render->gl->major,
                       render->gl->minor);
    render->gl->GenBuffers(1, &exact->corners);
    if (!write_triangles(render) || !make_program(render) || !open_cover(render) || !pass_exact_list(render))
        return false;
    make_array(render);
    set_clip(render);
    return gl_check(render->gl, "making exact shadows");
}

static void set_numbers(const Render *render, ScreenPass *pass)
{
    static const char *const names[4] = {"exact_right", "exact_up", "exact_back", "exact_eye"};
    const SceneCamera *camera = &render->scene->camera;
    const double *const axes[3] = {camera->right, camera->up, camera->back};
    for (int i = 0; i < 4; i++) {
        float lanes[4] = {0, 0, 0, i == 3 ? (float)render->exact.triangles.reach : 0};
        for (int k = 0; k < 3; k++)
            lanes[k] = (float)(i < 3 ? axes[i][k] : camera->position[k] - render->exact.triangles.origin[k]);
        material_set(&pass->material, &(MaterialValue){names[i], 4, lanes});
    }
}

static void set_all_numbers(Render *render)
{
    ScreenPass *passes[] = {&render->light, &render->far.gather, &render->blend, &render->peel};
    set_clip(render);
    for (size_t i = 0; i < sizeof passes / sizeof *passes; i++)
        if (passes[i]->material.store)
            set_numbers(render, passes[i]);
}

bool pass_exact_change(Render *render, bool lights)
{
    const bool there = render->exact.array, needed = pass_exact_needed(render);
    if (!there && lights && needed && render->light.material.store)
        return gl_fail(render->gl, "shadows are exact where none were otherwise: this is another scene");
    if (there && !needed)
        return gl_fail(render->gl, "no shadows are exact where some were: this is another scene");
    if (there)
        set_all_numbers(render);
    return !there || !lights || pass_exact_list(render);
}

/* Of the cache's places that are opaque, the first and the one behind the last of these objects. None: range[0] >= range[1]. */
static void find_range(const Render *render, const int objects[2], int range[2])
{
    range[0] = render->exact.triangles.object_count;
    range[1] = 0;
    for (int object = objects[0]; object < objects[1]; object++) {
        const int place = render->cache.place_of[object];
        if (place < 0 || place >= render->exact.triangles.object_count)
            continue;
        range[0] = place < range[0] ? place : range[0];
        range[1] = place >= range[1] ? place + 1 : range[1];
    }
}

/* The cache's order is another, as an object is mirrored now. */
static bool is_reordered(const Render *render)
{
    bool is = false;
    for (int i = 0; i < render->exact.triangles.object_count; i++)
        is |= render->exact.triangles.objects[i].object != render->cache.places[i].object;
    return is;
}

/* Corners of all objects, if what they are counted from moves. */
static bool move(Render *render, int range[2])
{
    double before[3];
    ExactTriangles *triangles = &render->exact.triangles;
    memcpy(before, triangles->origin, sizeof before);
    if (!exact_triangles_move(render->scene, &render->cache, range, triangles))
        return gl_fail(render->gl, "out of memory");
    if (memcmp(before, triangles->origin, sizeof before) != 0)
        range[0] = 0, range[1] = triangles->object_count;
    return write_corners(render, range);
}

bool pass_exact_move(Render *render, int first, int count)
{
    int range[2];
    if (!render->exact.array)
        return true;
    find_range(render, (int[]){first, first + count}, range);
    const bool again = is_reordered(render);
    if (!again && range[0] >= range[1])
        return true;
    if (!(again ? write_triangles(render) : move(render, range)))
        return false;
    set_all_numbers(render);
    return pass_exact_list(render);
}

void pass_exact_draw(Render *render)
{
    static const GLuint none[4];
    static const float far[4];
    const GlContext *gl = render->gl;
    pass_surface_begin(render, &render->draws[FRAME_DRAW_seen], GL_GREATER);
    gl->ClearBufferuiv(GL_COLOR, 0, none);
    gl->ClearBufferfv(GL_DEPTH, 0, far);
    material_use(&render->exact.material);
    gl->BindVertexArray(render->exact.array);
    gl->DrawArrays(GL_TRIANGLES, 0, 3 * render->exact.triangles.count);
    gl->BindVertexArray(0);
    pass_surface_end(render);
}

void pass_exact_delete(Render *render)
{
    const GlContext *gl = render->gl;
    ExactShadows *exact = &render->exact;
    if (exact->material.store)
        material_delete(&exact->material);
    gl->DeleteVertexArrays(1, &exact->array); /* GL ignores the name 0 */
    gl->DeleteBuffers(1, &exact->corners);
    exact_cover_empty(&exact->cover);
    exact_triangles_free(&exact->triangles);
    *exact = (ExactShadows){.cover = exact->cover};
}

/* -- for the lighting of surfaces */

void pass_exact_texts(const Render *render, bool seen, const char *texts[EXACT_TEXTS])
{
    const bool needed = pass_exact_needed(render);
    texts[0] = !needed ? "" : seen ? "#define EXACT\n#define EXACT_SEEN\n" : "#define EXACT\n";
    texts[1] = needed ? render_text_exact : "";
    texts[2] = needed && seen ? render_text_exact_seen : "";
}

void pass_exact_set(const Render *render, int unit, ScreenPass *pass)
{
    set_numbers(render, pass);
    screen_pass_sampler(pass, "exact_seen", unit);
}

void pass_exact_bind(const Render *render, int unit)
{
    const GlContext *gl = render->gl;
    if (!render->exact.array)
        return;
    texture_bind(gl, frame_texture(render, FRAME_TARGET_seen, 0), unit);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, TRIANGLES_BINDING, render->exact.corners);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, LISTS_BINDING, render->exact.cover.lists);
}
