/* Programs that write and read a layout, in the GLSL of any target. */
#include "gbuffer.h"
#include "compiler/layout/layout.h"
#include "compiler/pipeline.h"
#include "runtime/gl/program.h"
#include "runtime/gl/texture.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT_ROOM = 1 << 15 };

static bool fail(Gbuffer *g, const char *text)
{
    snprintf(g->error, sizeof g->error, "%s", text);
    return false;
}

static bool make_targets(Gbuffer *g)
{
    GLenum formats[FRAMEBUFFER_COLORS] = {0};
    FramebufferSpec spec = {GRID_WIDTH, GRID_HEIGHT, layout_targets(g->layout), 0, false};
    for (int i = 0; i < spec.color_count; i++)
        formats[i] = framebuffer_format(format_table[g->layout->formats[i]].name);
    return framebuffer_make_of(g->drawer->gl, &spec, formats, &g->targets) || fail(g, g->drawer->gl->error);
}

/* vec4(s.diffuse, 0., ...) */
static void slot_text(Slot slot, char *text, size_t room)
{
    static const char *const fill[] = {"", ", 0.0, 0.0, 0.0", ", 0.0, 0.0", ", 0.0", ""};
    snprintf(text, room, "vec4(s.%s%s)", slot_table[slot].name, fill[type_table[slot_table[slot].type].lanes]);
}

static GLuint make_reader(Gbuffer *g)
{
    static char text[TEXT_ROOM];
    const TargetRow *target = &target_table[g->shading.target];
    bool old = !target->in_out;
    int size =
        snprintf(text, sizeof text, "#version %s\n%s%s\nuniform int which;\n%s", target->version,
                 target->precision ? "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n" : "",
                 g->unpack, old ? "" : "layout(location = 0) out vec4 color;\n");
    size += snprintf(text + size, sizeof text - (size_t)size,
                     old ? "void main() {\n    Surface s = unpackSurface(gl_FragCoord.xy / vec2(%d.0, %d.0));\n"
                           "    vec4 value = vec4(0.0);\n"
                         : "void main() {\n    Surface s = unpackSurface(ivec2(gl_FragCoord.xy));\n"
                           "    vec4 value = vec4(0.0);\n",
                     GRID_WIDTH, GRID_HEIGHT);
    for (int slot = 0; slot < SLOT_COUNT; slot++) {
        char value[96];
        if (!layout_has_slot(g->layout, (Slot)slot))
            continue;
        slot_text((Slot)slot, value, sizeof value);
        size += snprintf(text + size, sizeof text - (size_t)size, "    if (which == %d) value = %s;\n", slot, value);
    }
    snprintf(text + size, sizeof text - (size_t)size, "    %s = value;\n}\n", old ? "gl_FragColor" : "color");
    return drawer_program(g->drawer, &(Shading){.fragment = text, .target = g->shading.target});
}

static bool make_programs(Gbuffer *g)
{
    gl_use(g->drawer->gl);
    if (!make_targets(g))
        return false;
    g->writer = drawer_program(g->drawer, &g->shading);
    g->reader = g->writer ? make_reader(g) : 0;
    return g->reader || fail(g, g->drawer->error);
}

bool gbuffer_open(Gbuffer *g, Drawer *drawer, const MatcDocument *document, const Graph *graph,
                  const MatcOptions *options)
{
    return gbuffer_open_material(g, drawer, document, graph, 0, options);
}

bool gbuffer_open_material(Gbuffer *g, Drawer *drawer, const MatcDocument *document, const Graph *graph, int material,
                           const MatcOptions *options)
{
    Job job;
    *g = (Gbuffer){.drawer = drawer};
    if (choice_job(options, &job))
        return fail(g, "no such option");
    g->layout = job.layout;
    g->program = matc_compile(document, material, MATC_FRAGMENT | MATC_VERTEX | MATC_UNPACK, options);
    if (!matc_ok(g->program))
        return fail(g, matc_program_diagnostics(g->program, MATC_TEXT));
    g->unpack = matc_output(g->program, MATC_UNPACK, NULL);
    g->shading = (Shading){.fragment = matc_output(g->program, MATC_FRAGMENT, NULL),
                           .target = job.target,
                           .program = g->program,
                           .graph = graph};
    return make_programs(g);
}

bool gbuffer_open_layout(Gbuffer *g, Drawer *drawer, Document *d, const LayoutRow *layout, const MatcOptions *options)
{
    Job job;
    Products products;
    *g = (Gbuffer){.drawer = drawer, .layout = layout};
    if (choice_job(options, &job))
        return fail(g, "no such option");
    job.layout = layout;
    d->session.optimize = options->optimize;
    d->session.check = true;
    Ir *ir = compile_ir(&d->session, d->graph, d->graph->materials[0].node, &job);
    if (!ir || !compile_back(&d->session, ir, &job, &products))
        return fail(g, d->session.diags.count ? d->session.diags.at[0].message : "it does not compile");
    g->unpack = emit_unpack(&d->session, &job);
    g->shading = (Shading){.fragment = products.fragment, .target = job.target, .graph = d->graph};
    return make_programs(g);
}

void gbuffer_close(Gbuffer *g)
{
    gl_use(g->drawer->gl);
    g->drawer->gl->DeleteProgram(g->writer);
    g->drawer->gl->DeleteProgram(g->reader);
    framebuffer_delete(g->drawer->gl, &g->targets);
    matc_program_free(g->program);
    *g = (Gbuffer){0};
}

bool gbuffer_draw(Gbuffer *g, bool front)
{
    return drawer_draw_to(g->drawer, g->writer, &g->shading, front, &g->targets) || fail(g, g->drawer->error);
}

bool gbuffer_read(Gbuffer *g, Slot slot, float *rgba)
{
    GlContext *gl = g->drawer->gl;
    gl_use(gl);
    for (int i = 0; i < g->targets.spec.color_count; i++) {
        char name[32];
        snprintf(name, sizeof name, "matc_gbuffer%d", i);
        texture_bind(gl, g->targets.colors[i], i);
        program_set(gl, g->reader, &(ProgramValue){name, 1, &(float){(float)i}});
    }
    program_set(gl, g->reader, &(ProgramValue){"which", 1, &(float){(float)slot}});
    return drawer_draw(g->drawer, g->reader, &(Shading){.target = g->shading.target}, true, &rgba, 1) ||
           fail(g, g->drawer->error);
}
