/* The pass exact: which triangle each pixel sees; and what exact shadows read, made once for a scene: the triangles of all that is opaque, and the
 * lists of exact_lists.h. exact.glsl says what becomes of them. */
#include "compiler/base/session.h"
#include "runtime/render/frame.h"

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

static bool fits(Render *render, size_t bytes)
{
    const size_t most = transparency_most_bytes(render);
    return bytes <= most || gl_fail(render->gl, "shadows: exact takes %lu bytes in a buffer, and there may be %lu",
                                    (unsigned long)bytes, (unsigned long)most);
}

static bool write_buffer(Render *render, GLuint *buffer, const void *from, size_t bytes)
{
    const GlContext *gl = render->gl;
    if (!fits(render, bytes))
        return false;
    if (!*buffer)
        gl->GenBuffers(1, buffer);
    gl->BindBuffer(GL_ARRAY_BUFFER, *buffer);
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)bytes, from, GL_DYNAMIC_DRAW);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
    return gl_check(render->gl, "making room for exact shadows");
}

static bool write_lists(Render *render, const ExactTriangles *triangles)
{
    const ExactListsSource source = {render->scene, triangles, transparency_most_bytes(render) / sizeof(uint32_t)};
    ExactShadows *exact = &render->exact;
    ExactLists lists;
    if (!exact_lists_make(&source, &lists))
        return lists.count ? fits(render, lists.count * sizeof *lists.words) : gl_fail(render->gl, "out of memory");
    exact->list_bytes = lists.count * sizeof *lists.words;
    exact->list_count = lists.light_count;
    exact->longest = lists.longest;
    const bool done = write_buffer(render, &exact->lists, lists.words, exact->list_bytes);
    exact_lists_free(&lists);
    return done;
}

static bool write_all(Render *render)
{
    ExactShadows *exact = &render->exact;
    ExactTriangles triangles;
    const double start = session_now();
    if (!exact_triangles_make(render->scene, &render->cache, &triangles))
        return gl_fail(render->gl, "out of memory");
    const size_t bytes = (size_t)triangles.count * sizeof *triangles.corners;
    for (int i = 0; i < 3; i++)
        exact->origin[i] = triangles.origin[i];
    exact->reach = triangles.reach;
    exact->triangle_count = triangles.count;
    const bool done =
        write_buffer(render, &exact->triangles, triangles.corners, bytes) && write_lists(render, &triangles);
    exact_triangles_free(&triangles);
    exact->seconds = session_now() - start;
    return done;
}

/* -- which triangle is seen */

/* Clip space from where corners are counted from: a product in double, of a matrix that the driver has in floats. */
static void set_clip(Render *render)
{
    const float *clip = render->space.spaces.clip_from_eye.m;
    const double *eye = render->space.eye_from_world, *origin = render->exact.origin;
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
    gl->BindBuffer(GL_ARRAY_BUFFER, render->exact.triangles);
    gl->EnableVertexAttribArray(0);
    gl->VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 3 * sizeof(float), NULL);
    gl->BindVertexArray(0);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
}

bool pass_exact_make(Render *render)
{
    if (!transparency_has_lists(render->gl))
        return gl_fail(render->gl, "shadows: exact takes OpenGL 4.3, and the driver has %d.%d", render->gl->major,
                       render->gl->minor);
    if (!write_all(render) || !make_program(render))
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
        float lanes[4] = {0, 0, 0, i == 3 ? (float)render->exact.reach : 0};
        for (int k = 0; k < 3; k++)
            lanes[k] = (float)(i < 3 ? axes[i][k] : camera->position[k] - render->exact.origin[k]);
        material_set(&pass->material, &(MaterialValue){names[i], 4, lanes});
    }
}

bool pass_exact_change(Render *render, bool drawn_again)
{
    ScreenPass *passes[] = {&render->light, &render->far.gather, &render->blend, &render->peel};
    const int before = render->exact.list_count;
    if (!render->exact.array && drawn_again && pass_exact_needed(render) && render->light.material.store)
        return gl_fail(render->gl, "shadows are exact where none were otherwise: this is another scene");
    if (!render->exact.array)
        return true;
    if (drawn_again && !write_all(render))
        return false;
    if (before && !render->exact.list_count)
        return gl_fail(render->gl, "no shadows are exact where some were: this is another scene");
    set_clip(render);
    for (size_t i = 0; drawn_again && i < sizeof passes / sizeof *passes; i++)
        if (passes[i]->material.store)
            set_numbers(render, passes[i]);
    return true;
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
    gl->DrawArrays(GL_TRIANGLES, 0, 3 * render->exact.triangle_count);
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
    gl->DeleteBuffers(1, &exact->triangles);
    gl->DeleteBuffers(1, &exact->lists);
    *exact = (ExactShadows){.array = 0};
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
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, TRIANGLES_BINDING, render->exact.triangles);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, LISTS_BINDING, render->exact.lists);
}
