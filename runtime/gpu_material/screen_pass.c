/* Assembles a pass from version, body and entry point; draws or dispatches it. */
#include "runtime/gpu_material/screen_pass.h"
#include "gen/render_text.h"
#include <stdio.h>
#include <string.h>

enum { GROUP = 8, HEAD_CAPACITY = 128 };

static const struct {
    const char *name, *qualifier;
    GLenum format;
} formats[] = {{"RGBA16F", "rgba16f", GL_RGBA16F},
               {"RGBA32F", "rgba32f", GL_RGBA32F},
               {"RGBA8", "rgba8", GL_RGBA8},
               {"RGBA16", "rgba16", GL_RGBA16}};

void screen_pass_add(ScreenPassText *text, const char *piece)
{
    int count = 0;
    while (count < SCREEN_PASS_PIECES && text->body[count])
        count++;
    if (!piece || !*piece)
        return;
    if (count < SCREEN_PASS_PIECES)
        text->body[count] = piece;
    else
        text->full = true;
}

void screen_pass_add_all(ScreenPassText *text, const char *const *pieces, int count)
{
    for (int i = 0; i < count; i++)
        screen_pass_add(text, pieces[i]);
}

static int find_format(const char *name)
{
    int i = 0;
    while (strcmp(formats[i].name, name) != 0)
        i++;
    return i;
}

static const char *entry_of(const ScreenPassText *text)
{
    if (text->compute)
        return text->over ? render_text_entry_over_compute : render_text_entry_compute;
    return text->over ? render_text_entry_over_fragment : render_text_entry_fragment;
}

bool screen_pass_make(Store *store, const ScreenPassText *text, ScreenPass *made)
{
    GlContext *gl = store_context(store);
    if (text->full)
        return gl_fail(gl, "a pass has more than %d pieces of GLSL", SCREEN_PASS_PIECES);
    const int format = find_format(text->format), version = gl->major * 10 + gl->minor;
    char head[HEAD_CAPACITY];
    snprintf(head, sizeof head, "#version %s core\n#define ENTRY_FORMAT %s\n",
             version >= 45   ? "450"
             : version >= 43 ? "430"
                             : "330",
             formats[format].qualifier);
    const char *pieces[PROGRAM_PIECES] = {head};
    int count = 1;
    for (int i = 0; i < SCREEN_PASS_PIECES && text->body[i]; i++)
        pieces[count++] = text->body[i];
    if (!text->block)
        pieces[count] = entry_of(text);
    ProgramText program = {0};
    memcpy(text->compute ? program.compute : program.fragment, pieces, sizeof pieces);
    if (!text->compute) {
        program.vertex[0] = head;
        program.vertex[1] = screen_text;
    }
    *made = (ScreenPass){.compute = text->compute,
                         .over = text->over,
                         .block = text->block ? text->block : GROUP,
                         .layers = 1,
                         .format = formats[format].format};
    return material_make(store, NULL, &program, &made->material);
}

void screen_pass_sampler(ScreenPass *pass, const char *name, int unit)
{
    material_set_number(&pass->material, name, (float)unit);
}

static void draw(ScreenPass *pass, const Framebuffer *target, const Screen *screen)
{
    GlContext *gl = store_context(pass->material.store);
    framebuffer_use(gl, target);
    material_use(&pass->material);
    if (pass->over) {
        gl->Enable(GL_BLEND);
        gl->BlendFunc(GL_ONE, GL_SRC1_COLOR);
    }
    screen_draw(gl, screen);
    if (pass->over) {
        gl->Disable(GL_BLEND);
        /* Mesa rejects a dual-source factor with several targets even with blending disabled. */
        gl->BlendFunc(GL_ONE, GL_ZERO);
    }
}

/* Memory barrier: later passes read the images and buffers that programs wrote. */
static void settle(const GlContext *gl)
{
    if (gl->major * 10 + gl->minor >= 43 && gl->MemoryBarrier)
        gl->MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT |
                          GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                          GL_BUFFER_UPDATE_BARRIER_BIT);
}

void screen_pass_run(ScreenPass *pass, const Framebuffer *target, const Screen *screen)
{
    GlContext *gl = store_context(pass->material.store);
    const GLuint block = (GLuint)pass->block;
    if (!pass->compute) {
        draw(pass, target, screen);
        settle(gl);
        return;
    }
    material_use(&pass->material);
    gl->BindImageTexture(0, target->colors[0], 0, GL_FALSE, 0,
                         pass->over ? GL_READ_WRITE : GL_WRITE_ONLY, pass->format);
    gl->DispatchCompute(((GLuint)target->spec.width + block - 1) / block,
                        ((GLuint)target->spec.height + block - 1) / block, (GLuint)pass->layers);
    settle(gl);
}

void screen_pass_delete(ScreenPass *pass)
{
    if (pass->material.store)
        material_delete(&pass->material);
    *pass = (ScreenPass){0};
}
