/* Contexts, targets, points, unpacking, means. */
#include "runtime/measure/meter.h"
#include "compiler/layout/layout.h"
#include "runtime/gl/message.h"
#include "runtime/gl/program.h"
#include "runtime/gl/texture.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool fail(Meter *m, const char *what)
{
    return message_fail(m->error, sizeof m->error, "%s%s%s", what, *what ? ": " : "", m->gl->error);
}

Meter *meter_open(GlKind kind, char *error, size_t room)
{
    Meter *m = calloc(1, sizeof *m);
    if (!m)
        abort();
    m->gl = gl_open(kind, true, error, room);
    FramebufferSpec spec = {
        .width = POINTS_WIDTH, .height = POINTS_HEIGHT, .color_count = READ_TARGETS, .color_format = GL_RGBA32F};
    if (m->gl && spec.color_count > m->gl->max_draw_buffers)
        spec.color_count = m->gl->max_draw_buffers;
    if (m->gl && spec.color_count > FRAMEBUFFER_COLORS)
        spec.color_count = FRAMEBUFFER_COLORS;
    if (m->gl && framebuffer_make(m->gl, &spec, &m->numbers) && mesh_make_empty(m->gl, &m->screen))
        return m;
    if (m->gl)
        message_fail(error, room, "%s", m->gl->error);
    meter_close(m);
    return NULL;
}

void meter_close(Meter *m)
{
    if (!m)
        return;
    for (int i = 0; i < LAYOUT_COUNT && m->gl; i++)
        shader_delete(m->gl, &m->unpack[i]); /* the rest goes with the context */
    gl_close(m->gl);
    free(m);
}

bool meter_make_targets(Meter *m, Layout layout, int width, int height, Framebuffer *made)
{
    const LayoutRow *row = &layout_table[layout];
    GLenum formats[FRAMEBUFFER_COLORS] = {0};
    const FramebufferSpec spec = {.width = width, .height = height, .color_count = layout_targets(row)};
    for (int i = 0; i < spec.color_count && i < FRAMEBUFFER_COLORS; i++) {
        const char *name = format_table[row->formats[i]].name;
        formats[i] = framebuffer_format(name);
        if (!formats[i])
            return message_fail(m->error, sizeof m->error, "layout %s: %s is not known here", row->name, name);
    }
    return framebuffer_make_of(m->gl, &spec, formats, made) || fail(m, row->name);
}

static bool draw_field(Meter *m, const Shader *shader, const Field *field, const Framebuffer *target)
{
    framebuffer_use(m->gl, target);
    shader_use(m->gl, shader, (float[2]){0, 0});
    field_draw(m->gl, field);
    return gl_check(m->gl, "drawing") || fail(m, "");
}

bool meter_draw_points(Meter *m, const Shader *shader, const Field *points, float (*rgba)[4])
{
    return draw_field(m, shader, points, &m->numbers) &&
           (framebuffer_read(m->gl, &m->numbers, 0, &rgba[0][0]) || fail(m, ""));
}

/* main() of the unpacking program: a target a slot, as many as there are targets; `first` is the first slot's rank. */
static void unpack_main(const Meter *m, Layout layout, char *text, size_t room)
{
    size_t size = 0;
    int target = 0;
#define PUT(...) (size += (size_t)snprintf(text + size, size < room ? room - size : 0, __VA_ARGS__))
    for (int i = 0; i < m->numbers.spec.color_count; i++)
        PUT("layout(location = %d) out vec4 measured%d;\n", i, i);
    PUT("uniform int measure_first;\nvoid main() {\n    Surface s = unpackSurface(ivec2(gl_FragCoord.xy));\n"
        "    vec4 slots[%d];\n",
        SLOT_COUNT + FRAMEBUFFER_COLORS);
    for (int slot = 0; slot < SLOT_COUNT; slot++) {
        const SlotRow *row = &slot_table[slot];
        if (!m->holds[layout][slot])
            continue;
        int lanes = type_table[row->type].lanes;
        PUT("    slots[%d] = vec4(s.%s%s);\n", target++, row->name,
            lanes == 3   ? ", 0.0"
            : lanes == 2 ? ", 0.0, 0.0"
                         : "");
    }
    for (int i = 0; i < m->numbers.spec.color_count; i++)
        PUT("    measured%d = slots[measure_first + %d];\n", i, i);
    PUT("}\n");
#undef PUT
}

static bool make_unpack(Meter *m, Layout layout, const char *unpack)
{
    char body[FIELD_TEXT];
    static const char
        head[] = "#version 330 core\n",
        vertex[] =
            "#version 330 core\n"
            "void main() { gl_Position = vec4(gl_VertexID == 1 ? 3. : -1., gl_VertexID == 2 ? 3. : -1., 0., 1.); }";
    if (m->unpack[layout].name)
        return true;
    if (m->refused[layout] || !unpack)
        return message_fail(m->error, sizeof m->error, "layout %s is not to be had", layout_table[layout].name);
    m->refused[layout] = true;
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        m->holds[layout][slot] = layout_has_slot(&layout_table[layout], (Slot)slot);
    unpack_main(m, layout, body, sizeof body);
    if (!meter_make_targets(m, layout, POINTS_WIDTH, POINTS_HEIGHT, &m->packed[layout]))
        return false;
    ProgramText text = {.vertex = {vertex}, .fragment = {head, unpack, body}};
    m->unpack[layout].name = program_make(m->gl, &text);
    m->refused[layout] = !m->unpack[layout].name;
    return m->unpack[layout].name || fail(m, layout_table[layout].name);
}

static void bind_packed(Meter *m, Layout layout)
{
    char name[32];
    for (int i = 0; i < layout_targets(&layout_table[layout]); i++) {
        snprintf(name, sizeof name, "matc_gbuffer%d", i);
        texture_bind(m->gl, m->packed[layout].colors[i], i);
        program_set(m->gl, m->unpack[layout].name, &(ProgramValue){name, 1, &(float){(float)i}});
    }
}

/* The slots that the layout holds, as many at a time as there are targets. */
static bool read_slots(Meter *m, Layout layout, SlotValues *values)
{
    static const int most = FRAMEBUFFER_COLORS;
    float(*rgba)[4] = calloc(POINTS, sizeof *rgba);
    int rank = 0, first = 0;
    bool fine = rgba != NULL;
    for (int slot = 0; slot < SLOT_COUNT && fine; slot++) {
        for (int i = 0; i < POINTS && !m->holds[layout][slot]; i++)
            for (int lane = 0; lane < 4; lane++)
                values[i].lane[slot][lane] = NAN;
        if (!m->holds[layout][slot])
            continue;
        if (rank == 0 || rank - first == m->numbers.spec.color_count || rank - first == most) {
            first = rank;
            framebuffer_use(m->gl, &m->numbers);
            program_set(m->gl, m->unpack[layout].name, &(ProgramValue){"measure_first", 1, &(float){(float)first}});
            mesh_draw_screen(m->gl, &m->screen);
        }
        fine = framebuffer_read(m->gl, &m->numbers, rank++ - first, &rgba[0][0]) || fail(m, "");
        for (int i = 0; i < POINTS; i++)
            for (int lane = 0; lane < 4; lane++)
                values[i].lane[slot][lane] = rgba[i][lane];
    }
    free(rgba);
    return fine;
}

bool meter_draw_packed(Meter *m, const Shader *shader, Layout layout, const char *unpack_text, const Field *points,
                       SlotValues *values)
{
    if (!make_unpack(m, layout, unpack_text) || !draw_field(m, shader, points, &m->packed[layout]))
        return false;
    bind_packed(m, layout);
    m->gl->UseProgram(m->unpack[layout].name);
    return read_slots(m, layout, values);
}

/* A number in [0, 1) for each place, without pattern. */
static double scatter(unsigned seed)
{
    seed = (seed ^ seed >> 16) * 0x7FEB352Du;
    seed = (seed ^ seed >> 15) * 0x846CA68Bu;
    return (seed ^ seed >> 16) / 4294967296.;
}

bool meter_draw_mean(Meter *m, const Shader *shader, const Field *field, const Framebuffer *target, int n, float *rgba)
{
    const GlContext *gl = m->gl;
    size_t count = (size_t)target->spec.width * (size_t)target->spec.height * 4;
    framebuffer_use(gl, target);
    gl->ClearColor(0, 0, 0, 0);
    gl->Clear(GL_COLOR_BUFFER_BIT);
    gl->Enable(GL_BLEND);
    gl->BlendFunc(GL_ONE, GL_ONE);
    for (int i = 0; i < n * n; i++) {
        double x = n > 1 ? (i % n + scatter(2u * (unsigned)i)) / n - 0.5 : 0;
        double y = n > 1 ? (i / n + scatter(2u * (unsigned)i + 1)) / n - 0.5 : 0;
        const float jitter[2] = {(float)(2 * x / target->spec.width), (float)(2 * y / target->spec.height)};
        shader_use(m->gl, shader, jitter);
        field_draw(gl, field);
    }
    gl->Disable(GL_BLEND);
    if (!framebuffer_read(m->gl, target, 0, rgba))
        return fail(m, "");
    for (size_t i = 0; i < count; i++)
        rgba[i] /= (float)(n * n);
    return true;
}

bool meter_make_constant(Meter *m, Shader *made)
{
    static const char *const text = "#version 330 core\nlayout(location = 0) out vec4 colour;\nvoid main() { colour = "
                                    "vec4(0.25, 0.5, 0.75, 1.0); }\n";
    return shader_make_plain(m->gl, &text, 1, made) || fail(m, "the constant colour");
}
