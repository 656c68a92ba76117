/* Inputs of exact shadows, made once for a scene: the triangles of all shadow casters, and the
 * lists of exact_cover.h. exact.glsl reads them. */
#include "gen/render_text.h"
#include "runtime/frame_graph/frame.h"
#include "runtime/frame_graph/transparency_draw.h"
#include "runtime/exact/exact.h"
#include <stdlib.h>
#include <string.h>

enum { TRIANGLES_BINDING = 6, LISTS_BINDING = 7 };

/* -- buffers */

static size_t corner_bytes(int count) { return (size_t)count * sizeof(ExactCorners); }

/* Writes the corners of objects range[0] to range[1] - 1 to the buffer, which is allocated if
 * they are all. */
static bool write_corners(Renderer *renderer, const int range[2])
{
    const GlContext *gl = renderer->gl;
    ExactShadows *exact = exact_state(renderer);
    const ExactTriangles *triangles = &exact->triangles;
    const ExactObject *first = &triangles->objects[range[0]],
                      *last = &triangles->objects[range[1] - 1];
    const int count = last->first + last->count - first->first;
    ExactCorners *corners = malloc(corner_bytes(count) + 1);
    if (!corners ||
        !exact_triangles_corners(renderer->scene, &renderer->gpu_scene, triangles, range, corners))
        return free(corners), gl_fail(renderer->gl, "out of memory");
    gl->BindBuffer(GL_ARRAY_BUFFER, exact->corners);
    if (count == triangles->count)
        gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)corner_bytes(count), corners, GL_DYNAMIC_DRAW);
    else
        gl->BufferSubData(GL_ARRAY_BUFFER, (GLintptr)corner_bytes(first->first),
                          (GLsizeiptr)corner_bytes(count), corners);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
    free(corners);
    return gl_check(renderer->gl, "making room for exact shadows");
}

static bool measure(Renderer *renderer)
{
    const size_t most = transparency_most_bytes(renderer);
    ExactTriangles *triangles = &exact_state(renderer)->triangles;
    exact_triangles_free(triangles);
    if (!exact_triangles_make(renderer->scene, &renderer->gpu_scene, triangles))
        return gl_fail(renderer->gl, "out of memory");
    return corner_bytes(triangles->count) <= most ||
           gl_fail(renderer->gl, "shadows: exact takes %lu bytes in a buffer, and there may be %lu",
                   (unsigned long)corner_bytes(triangles->count), (unsigned long)most);
}

/* Writes the number of each object's first triangle, by the GPU scene's places. Without instancing,
 * the place is a uniform. */
static bool write_firsts(Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    const ExactTriangles *triangles = &exact_state(renderer)->triangles;
    const size_t bytes = (size_t)triangles->opaque_count * sizeof(GLuint);
    GLuint *firsts = malloc(bytes + 1);
    if (!firsts)
        return gl_fail(renderer->gl, "out of memory");
    for (int i = 0; i < triangles->opaque_count; i++) {
        firsts[i] = (GLuint)triangles->objects[i].first + 1;
        if (!renderer->gpu_scene.instances)
            material_set_number(
                &renderer->gpu_scene.kinds[renderer->gpu_scene.places[i].kind].material,
                "seen_place", (float)i);
    }
    gl->BindBuffer(GL_ARRAY_BUFFER, exact_state(renderer)->firsts);
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)bytes, firsts, GL_DYNAMIC_DRAW);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
    free(firsts);
    return true;
}

static bool write_triangles(Renderer *renderer)
{
    return measure(renderer) && write_firsts(renderer) &&
           write_corners(renderer, (int[]){0, exact_state(renderer)->triangles.object_count});
}

bool pass_exact_list(Renderer *renderer)
{
    ExactShadows *exact = exact_state(renderer);
    return exact_cover_make(&exact->cover, renderer->scene, &exact->triangles, exact->corners);
}

/* -- creation and changes */

bool pass_exact_wanted(const Renderer *renderer)
{
    return shadow_method_lights(renderer, KEYWORD_Shadows_exact) > 0 &&
           shadow_shows_light(renderer);
}

bool pass_exact_needed(const Renderer *renderer)
{
    bool casts = false;
    for (int i = 0; !casts && i < renderer->gpu_scene.place_count; i++)
        casts = exact_triangles_have(&renderer->gpu_scene.places[i]);
    return casts && pass_exact_wanted(renderer);
}

/* Compiles the programs unless an earlier scene has left them. */
static bool open_cover(Renderer *renderer)
{
    const size_t most = transparency_most_bytes(renderer) / sizeof(GLuint);
    return exact_state(renderer)->cover.cover.store ||
           exact_cover_open(renderer->store, most, &exact_state(renderer)->cover);
}

bool pass_exact_make(Renderer *renderer)
{
    GlContext *gl = renderer->gl;
    ExactShadows *exact = exact_state(renderer);
    if (!pass_exact_needed(renderer))
        return true;
    if (!transparency_has_lists(gl))
        return gl_fail(gl, "shadows: exact takes OpenGL 4.3, and the driver has %d.%d", gl->major,
                       gl->minor);
    if (!shadow_seen_fits(renderer))
        return gl_fail(
            gl,
            "shadows: exact takes one more target than the layout has, and the driver has no more");
    gl->GenBuffers(1, &exact->corners);
    gl->GenBuffers(1, &exact->firsts);
    return write_triangles(renderer) && open_cover(renderer) && pass_exact_list(renderer) &&
           gl_check(gl, "making exact shadows");
}

bool pass_exact_change(Renderer *renderer, unsigned what)
{
    const bool there = exact_state(renderer)->corners, needed = pass_exact_needed(renderer),
               lights = what & RENDERER_LIGHTS;
    if (!there && lights && needed && frame_has(renderer, FRAME_TARGET_light))
        return gl_fail(renderer->gl,
                       "exact shadows were turned on or off: the scene must be set again");
    if (there && !needed)
        return gl_fail(renderer->gl, "no shadows are exact where some were: this is another scene");
    return !there || !lights || pass_exact_list(renderer);
}

/* Finds the range of the triangles' objects that moved: first, and last plus one. None moved:
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

/* Returns true if the GPU scene's order has changed, as when an object becomes mirrored. */
static bool is_reordered(const Renderer *renderer)
{
    bool is = false;
    for (int i = 0, next = 0; i < renderer->gpu_scene.place_count; i++)
        if (exact_triangles_have(&renderer->gpu_scene.places[i]))
            is |= exact_state(renderer)->triangles.objects[next++].object !=
                  renderer->gpu_scene.places[i].object;
    return is;
}

/* Updates the corners of moved objects, or of all objects if the origin changes. */
static bool move(Renderer *renderer, int range[2])
{
    double before[3];
    ExactTriangles *triangles = &exact_state(renderer)->triangles;
    memcpy(before, triangles->origin, sizeof before);
    if (!exact_triangles_move(renderer->scene, &renderer->gpu_scene, range, triangles))
        return gl_fail(renderer->gl, "out of memory");
    if (memcmp(before, triangles->origin, sizeof before) != 0)
        range[0] = 0, range[1] = triangles->object_count;
    return write_corners(renderer, range);
}

bool pass_exact_move(Renderer *renderer, int first, int count)
{
    int range[2];
    if (!exact_state(renderer)->corners)
        return true;
    find_range(&exact_state(renderer)->triangles, (int[]){first, first + count}, range);
    const bool again = is_reordered(renderer);
    if (!again && range[0] >= range[1])
        return true;
    if (!(again ? write_triangles(renderer) : move(renderer, range)))
        return false;
    return pass_exact_list(renderer);
}

void pass_exact_delete(Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    ExactShadows *exact = exact_state(renderer);
    gl->DeleteBuffers(1, &exact->corners); /* GL ignores the name 0 */
    gl->DeleteBuffers(1, &exact->firsts);
    exact_cover_empty(&exact->cover);
    exact_triangles_free(&exact->triangles);
    *exact = (ExactShadows){.cover = exact->cover};
}
