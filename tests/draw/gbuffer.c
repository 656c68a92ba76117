/* Makes programs that write and read a layout, in the GLSL of any target. */
#include "gbuffer.h"
#include "compiler/pipeline.h"
#include <stdio.h>

static bool fail(Gbuffer *g, const char *text)
{
    snprintf(g->error, sizeof g->error, "%s", text);
    return false;
}

static bool make_all(Gbuffer *g)
{
    GlContext *gl = g->drawer->gl;
    const FramebufferSpec spec = g->drawer->target.spec; /* same size as the drawer's target */
    const ReaderSource source = {g->unpack, g->shading.target, g->layout, spec.width, spec.height};
    if (!drawer_material(g->drawer, &g->shading, &g->writer))
        return fail(g, g->drawer->error);
    return (targets_make_layout(gl, g->layout, &spec, &g->targets) &&
            reader_make(g->drawer->store, &source, &g->reader)) ||
           fail(g, gl->error);
}

bool gbuffer_open(Gbuffer *g, Drawer *drawer, const Document *document, int material,
                  const MatcOptions *options)
{
    Job job;
    *g = (Gbuffer){.drawer = drawer};
    if (choice_job(options, &job))
        return fail(g, "no such option");
    g->layout = job.layout;
    g->program = matc_compile(document->document, material,
                              MATC_FRAGMENT | MATC_VERTEX | MATC_UNPACK, options);
    if (!matc_ok(g->program))
        return fail(g, matc_program_diagnostics(g->program, MATC_TEXT));
    g->unpack = matc_output(g->program, MATC_UNPACK, NULL);
    g->shading = (Shading){.fragment = matc_output(g->program, MATC_FRAGMENT, NULL),
                           .target = job.target,
                           .program = g->program,
                           .graph = document->graph};
    return make_all(g);
}

bool gbuffer_open_layout(Gbuffer *g, Drawer *drawer, Document *d, const LayoutRow *layout,
                         const MatcOptions *options)
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
        return fail(g, d->session.diags.count ? d->session.diags.at[0].message
                                              : "it does not compile");
    g->unpack = emit_unpack(&d->session, &job);
    g->shading = (Shading){.fragment = products.fragment, .target = job.target, .graph = d->graph};
    return make_all(g);
}

void gbuffer_close(Gbuffer *g)
{
    gl_use(g->drawer->gl);
    material_delete(&g->writer);
    reader_delete(&g->reader);
    framebuffer_delete(g->drawer->gl, &g->targets);
    matc_program_free(g->program);
    *g = (Gbuffer){0};
}

bool gbuffer_draw(Gbuffer *g, bool front)
{
    drawer_set_uniforms(&g->shading, &g->writer);
    return drawer_draw_to(g->drawer, &g->writer, front, &g->targets) || fail(g, g->drawer->error);
}

bool gbuffer_read(Gbuffer *g, Slot slot, float *rgba)
{
    gl_use(g->drawer->gl);
    return reader_read(&g->reader, &g->targets, slot, rgba) || fail(g, g->drawer->gl->error);
}
