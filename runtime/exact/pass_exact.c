/* What exact shadows read, made once for a scene: the triangles of all that is opaque, and the
 * lists of exact_cover.h. exact.glsl says what becomes of them. */
#include "gen/render_text.h"
#include "runtime/cache/exact_number.h"
#include "runtime/frame/frame.h"
#include "runtime/frame/transparency_draw.h"
#include "runtime/exact/exact.h"
#include <stdlib.h>
#include <string.h>

enum { TRIANGLES_BINDING = 6, LISTS_BINDING = 7 };

/* -- buffers */

static size_t corner_bytes(int count) { return (size_t)count * sizeof(ExactCorners); }

/* Corners of objects range[0] to range[1] - 1, into a buffer that has room for all, or is made. */
static bool write_corners(Render *render, const int range[2])
{
    const GlContext *gl = render->gl;
    ExactShadows *exact = render->exact;
    const ExactTriangles *triangles = &exact->triangles;
    const ExactObject *first = &triangles->objects[range[0]],
                      *last = &triangles->objects[range[1] - 1];
    const int count = last->first + last->count - first->first;
    ExactCorners *corners = malloc(corner_bytes(count) + 1);
    if (!corners ||
        !exact_triangles_corners(render->scene, &render->cache, triangles, range, corners))
        return free(corners), gl_fail(render->gl, "out of memory");
    gl->BindBuffer(GL_ARRAY_BUFFER, exact->corners);
    if (count == triangles->count)
        gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)corner_bytes(count), corners, GL_DYNAMIC_DRAW);
    else
        gl->BufferSubData(GL_ARRAY_BUFFER, (GLintptr)corner_bytes(first->first),
                          (GLsizeiptr)corner_bytes(count), corners);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
    free(corners);
    return gl_check(render->gl, "making room for exact shadows");
}

static bool measure(Render *render)
{
    const size_t most = transparency_most_bytes(render);
    ExactTriangles *triangles = &render->exact->triangles;
    exact_triangles_free(triangles);
    if (!exact_triangles_make(render->scene, &render->cache, triangles))
        return gl_fail(render->gl, "out of memory");
    return corner_bytes(triangles->count) <= most ||
           gl_fail(render->gl, "shadows: exact takes %lu bytes in a buffer, and there may be %lu",
                   (unsigned long)corner_bytes(triangles->count), (unsigned long)most);
}

/* By places of the cache. A surface that is no instance has a uniform for its own. */
static bool write_firsts(Render *render)
{
    const GlContext *gl = render->gl;
    const ExactTriangles *triangles = &render->exact->triangles;
    const size_t bytes = (size_t)triangles->opaque_count * sizeof(GLuint);
    GLuint *firsts = malloc(bytes + 1);
    if (!firsts)
        return gl_fail(render->gl, "out of memory");
    for (int i = 0; i < triangles->opaque_count; i++) {
        firsts[i] = (GLuint)triangles->objects[i].first + 1;
        if (!render->cache.instances)
            material_set_number(&render->cache.kinds[render->cache.places[i].kind].material,
                                "exact_place", (float)i);
    }
    gl->BindBuffer(GL_ARRAY_BUFFER, render->exact->firsts);
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)bytes, firsts, GL_DYNAMIC_DRAW);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
    free(firsts);
    return true;
}

static bool write_triangles(Render *render)
{
    return measure(render) && write_firsts(render) &&
           write_corners(render, (int[]){0, render->exact->triangles.object_count});
}

bool pass_exact_list(Render *render)
{
    ExactShadows *exact = render->exact;
    return exact_cover_make(&exact->cover, render->scene, &exact->triangles, exact->corners);
}

/* -- made and changed */

static bool has_target(const Render *render)
{
    int targets = 0;
    while (set_format(&render->set, targets))
        targets++;
    return targets < render->gl->max_draw_buffers && targets < FRAMEBUFFER_COLORS;
}

/* Its programs stay for the next scene. */
static bool open_cover(Render *render)
{
    const size_t most = transparency_most_bytes(render) / sizeof(GLuint);
    return render->exact->cover.cover.store ||
           exact_cover_open(render->store, most, &render->exact->cover);
}

bool pass_exact_make(Render *render)
{
    GlContext *gl = render->gl;
    ExactShadows *exact = render->exact;
    if (!exact_lights_cast(render))
        return true;
    if (!transparency_has_lists(gl))
        return gl_fail(gl, "shadows: exact takes OpenGL 4.3, and the driver has %d.%d", gl->major,
                       gl->minor);
    if (!has_target(render))
        return gl_fail(
            gl,
            "shadows: exact takes one more target than the layout has, and the driver has no more");
    gl->GenBuffers(1, &exact->corners);
    gl->GenBuffers(1, &exact->firsts);
    return write_triangles(render) && open_cover(render) && pass_exact_list(render) &&
           gl_check(gl, "making exact shadows");
}

static void set_numbers(const Render *render, ScreenPass *pass)
{
    static const char *const names[4] = {"exact_right", "exact_up", "exact_back", "exact_eye"};
    const SceneCamera *camera = &render->scene->camera;
    const double *const axes[3] = {camera->right, camera->up, camera->back};
    for (int i = 0; i < 4; i++) {
        float lanes[4] = {0, 0, 0, i == 3 ? (float)render->exact->triangles.reach : 0};
        for (int k = 0; k < 3; k++)
            lanes[k] = (float)(i < 3 ? axes[i][k]
                                     : camera->position[k] - render->exact->triangles.origin[k]);
        material_set(&pass->material, &(MaterialValue){names[i], 4, lanes});
    }
}

bool pass_exact_change(Render *render, unsigned what)
{
    const bool there = render->exact->corners, needed = exact_lights_cast(render),
               lights = what & RENDER_LIGHTS;
    render->exact->seen &= !(what & RENDER_CAMERA);
    if (!there && lights && needed && frame_has(render, FRAME_TARGET_light))
        return gl_fail(render->gl,
                       "shadows are exact where none were otherwise: this is another scene");
    if (there && !needed)
        return gl_fail(render->gl, "no shadows are exact where some were: this is another scene");
    return !there || !lights || pass_exact_list(render);
}

/* Of the triangles' objects, the first and the one behind the last that stand elsewhere. None:
 * range[0] >= range[1]. */
static void find_range(const ExactTriangles *triangles, const int objects[2], int range[2])
{
    range[0] = triangles->object_count;
    range[1] = 0;
    for (int i = 0; i < triangles->object_count; i++)
        if (triangles->objects[i].object >= objects[0] &&
            triangles->objects[i].object < objects[1]) {
            range[0] = i < range[0] ? i : range[0];
            range[1] = i + 1;
        }
}

/* The cache's order is another, as an object is mirrored now. */
static bool is_reordered(const Render *render)
{
    bool is = false;
    for (int i = 0, next = 0; i < render->cache.place_count; i++)
        if (exact_triangles_have(&render->cache.places[i]))
            is |= render->exact->triangles.objects[next++].object != render->cache.places[i].object;
    return is;
}

/* Corners of all objects, if what they are counted from moves. */
static bool move(Render *render, int range[2])
{
    double before[3];
    ExactTriangles *triangles = &render->exact->triangles;
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
    if (!render->exact->corners) {
        render->exact->seen = false; /* triangle ids for silhouettes */
        return true;
    }
    find_range(&render->exact->triangles, (int[]){first, first + count}, range);
    const bool again = is_reordered(render);
    if (!again && range[0] >= range[1])
        return true;
    render->exact->seen = false;
    if (!(again ? write_triangles(render) : move(render, range)))
        return false;
    return pass_exact_list(render);
}

void pass_exact_begin(const Render *render)
{
    if (render->exact->corners)
        render->gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, EXACT_NUMBER_FIRSTS,
                                   render->exact->firsts);
}

void pass_exact_delete(Render *render)
{
    const GlContext *gl = render->gl;
    ExactShadows *exact = render->exact;
    gl->DeleteBuffers(1, &exact->corners); /* GL ignores the name 0 */
    gl->DeleteBuffers(1, &exact->firsts);
    exact_cover_empty(&exact->cover);
    exact_triangles_free(&exact->triangles);
    *exact = (ExactShadows){.cover = exact->cover};
}

/* -- for the lighting of surfaces */

void pass_exact_texts(const Render *render, bool seen, const char *texts[EXACT_TEXTS])
{
    const bool needed = exact_lights_cast(render);
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
    if (!render->exact->corners)
        return;
    texture_bind(gl, frame_texture(render, FRAME_TARGET_seen, 0), unit);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, TRIANGLES_BINDING, render->exact->corners);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, LISTS_BINDING, render->exact->cover.lists);
}
