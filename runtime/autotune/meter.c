/* Contexts, render targets, drawing of points, unpacking and supersampled means. */
#include "runtime/autotune/meter.h"
#include "runtime/gl/message.h"
#include <math.h>
#include <stdlib.h>

static bool fail(Meter *m, const char *what)
{
    return message_fail(m->error, sizeof m->error, "%s%s%s", what, *what ? ": " : "", m->gl->error);
}

Meter *meter_open(GlKind kind, char *error, size_t capacity)
{
    const FramebufferSpec spec = {POINTS_WIDTH, POINTS_HEIGHT, 1, GL_RGBA32F, false};
    Meter *m = calloc(1, sizeof *m);
    if (!m)
        abort();
    m->gl = gl_open(kind, true, error, capacity);
    m->store = m->gl ? store_new(m->gl) : NULL;
    if (m->store && framebuffer_make(m->gl, &spec, &m->numbers))
        return m;
    if (m->gl)
        message_fail(error, capacity, "%s", m->gl->error);
    meter_close(m);
    return NULL;
}

void meter_close(Meter *m)
{
    if (!m)
        return;
    for (int i = 0; i < LAYOUT_COUNT; i++)
        reader_delete(&m->readers[i]);
    store_free(m->store);
    gl_close(m->gl); /* also deletes all GL objects of the context */
    free(m);
}

bool meter_make_material(Meter *m, MatcProgram *program, Material *made)
{
    return field_material(m->store, program, &(FieldText){.target = TARGET_glsl330}, made) ||
           fail(m, "");
}

bool meter_make_targets(Meter *m, Layout layout, int width, int height, Framebuffer *made)
{
    const LayoutRow *row = &layout_table[layout];
    const FramebufferSpec spec = {.width = width, .height = height};
    return targets_make_layout(m->gl, row, &spec, made) || fail(m, row->name);
}

void meter_use(const Meter *m, const MeterDraw *draw, const float jitter[2])
{
    framebuffer_use(m->gl, draw->target);
    material_set(draw->material, &(MaterialValue){"field_jitter", 2, jitter});
    material_use(draw->material);
}

static bool draw_once(Meter *m, const MeterDraw *draw)
{
    meter_use(m, draw, (float[2]){0, 0});
    field_draw(m->gl, draw->field);
    return gl_check(m->gl, "drawing") || fail(m, "");
}

bool meter_draw_points(Meter *m, Material *material, const Field *points, float (*rgba)[4])
{
    return draw_once(m, &(MeterDraw){material, points, &m->numbers}) &&
           (framebuffer_read(m->gl, &m->numbers, 0, &rgba[0][0]) || fail(m, ""));
}

bool meter_open_layout(Meter *m, Layout layout, const char *unpack)
{
    const LayoutRow *row = &layout_table[layout];
    const ReaderSource source = {unpack, TARGET_glsl330, row, POINTS_WIDTH, POINTS_HEIGHT};
    if (m->packed[layout].name)
        return true;
    if (m->refused[layout] || !unpack)
        return message_fail(m->error, sizeof m->error, "layout %s is not to be had", row->name);
    m->refused[layout] = true;
    if (!reader_make(m->store, &source, &m->readers[layout]))
        return fail(m, row->name);
    m->refused[layout] =
        !meter_make_targets(m, layout, POINTS_WIDTH, POINTS_HEIGHT, &m->packed[layout]);
    return !m->refused[layout];
}

static bool read_slot(Meter *m, Layout layout, Slot slot, float (*rgba)[4])
{
    const bool held = m->readers[layout].holds[slot];
    for (int i = 0; i < POINTS && !held; i++)
        for (int component = 0; component < 4; component++)
            rgba[i][component] = NAN;
    return !held || reader_read(&m->readers[layout], &m->packed[layout], slot, &rgba[0][0]) ||
           fail(m, "");
}

bool meter_draw_packed(Meter *m, Material *material, Layout layout, const Field *points,
                       SlotValues *values)
{
    float(*rgba)[4] = calloc(POINTS, sizeof *rgba);
    if (!rgba)
        abort();
    bool fine = draw_once(m, &(MeterDraw){material, points, &m->packed[layout]});
    for (int slot = 0; slot < SLOT_COUNT && fine; slot++) {
        fine = read_slot(m, layout, (Slot)slot, rgba);
        for (int i = 0; i < POINTS; i++)
            for (int component = 0; component < 4; component++)
                values[i].component[slot][component] = rgba[i][component];
    }
    free(rgba);
    return fine;
}

/* Hashes an integer to a number in [0, 1). */
static double scatter(unsigned seed)
{
    seed = (seed ^ seed >> 16) * 0x7FEB352Du;
    seed = (seed ^ seed >> 15) * 0x846CA68Bu;
    return (seed ^ seed >> 16) / 4294967296.;
}

bool meter_draw_mean(Meter *m, const MeterDraw *draw, int n, float *rgba)
{
    const GlContext *gl = m->gl;
    const FramebufferSpec *spec = &draw->target->spec;
    size_t count = (size_t)spec->width * (size_t)spec->height * 4;
    framebuffer_use(gl, draw->target);
    gl->ClearColor(0, 0, 0, 0);
    gl->Clear(GL_COLOR_BUFFER_BIT);
    gl->Enable(GL_BLEND);
    gl->BlendFunc(GL_ONE, GL_ONE);
    for (int i = 0; i < n * n; i++) {
        double x = n > 1 ? (i % n + scatter(2u * (unsigned)i)) / n - 0.5 : 0;
        double y = n > 1 ? (i / n + scatter(2u * (unsigned)i + 1)) / n - 0.5 : 0;
        meter_use(m, draw, (float[2]){(float)(2 * x / spec->width), (float)(2 * y / spec->height)});
        field_draw(gl, draw->field);
    }
    gl->Disable(GL_BLEND);
    if (!framebuffer_read(m->gl, draw->target, 0, rgba))
        return fail(m, "");
    for (size_t i = 0; i < count; i++)
        rgba[i] /= (float)(n * n);
    return true;
}

bool meter_make_constant(Meter *m, Material *made)
{
    static const char text[] =
        "#version 330 core\nlayout(location = 0) out vec4 colour;\nvoid main() { colour = "
        "vec4(0.25, 0.5, 0.75, 1.0); }\n";
    const FieldText field = {TARGET_glsl330, text, NULL};
    return field_material(m->store, NULL, &field, made) || fail(m, "the constant color");
}
