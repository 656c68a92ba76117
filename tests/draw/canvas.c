/* Makes one program per drawing: its functions as chunks.c gathers them, and a line of main. */
#include "canvas.h"
#include "compiler/emit/chunks.h"
#include "runtime/gl/program.h"
#include <stdio.h>
#include <string.h>
#include <time.h>

enum { LIBRARY_CAPACITY = 1 << 16, MAIN_CAPACITY = 4096 };

bool canvas_open(Canvas *c, int side)
{
    *c = (Canvas){.side = side};
    c->gl = gl_open(GL_KIND_osmesa, true, c->error, sizeof c->error);
    FramebufferSpec spec = {side, side, 1, GL_RGBA32F, false};
    if (!c->gl || !screen_make(c->gl, &c->screen) || !framebuffer_make(c->gl, &spec, &c->floats))
        return false;
    spec.color_format = GL_RGBA16F;
    if (!framebuffer_make(c->gl, &spec, &c->halves))
        return false;
    spec.color_format = GL_RGBA32UI;
    return framebuffer_make(c->gl, &spec, &c->words);
}

void canvas_close(Canvas *c)
{
    if (c->gl)
        gl_close(c->gl);
    *c = (Canvas){0};
}

bool canvas_library(const char *functions, const Choice *choice, char *library, size_t capacity)
{
    MatcOptions options = {0};
    Arena arena = {0};
    Session session = {.options = &options, .arena = &arena};
    Chunks chunks = {0};
    Job job = {.target = TARGET_glsl330, .layout = &layout_table[LAYOUT_thesis]};
    bool found = true;
    for (int axis = 0; axis < AXIS_COUNT; axis++)
        job.choice[axis] = (Choice)axis_table[axis].first;
    if (choice)
        job.choice[choice_table[*choice].axis] = *choice;
    for (const char *name = functions; *name && found;) {
        int size = (int)strcspn(name, " ");
        char one[64];
        snprintf(one, sizeof one, "%.*s", size, name);
        found = chunks_add(&session, &chunks, one, &job);
        name += size;
        name += strspn(name, " ");
    }
    library[0] = 0;
    for (size_t i = 0; i < chunks.count; i++)
        strncat(library, chunks.at[i]->body, capacity - 1 - strlen(library));
    arena_free(&arena);
    return found;
}

static GLuint make_program(Canvas *c, const Drawing *d, bool words)
{
    static char library[LIBRARY_CAPACITY];
    char head[256], body[MAIN_CAPACITY];
    bool reads_words = d->source && framebuffer_has_words(d->source, 0),
         reads = d->source || d->texture;
    if (!canvas_library(d->functions, NULL, library, sizeof library)) {
        gl_fail(c->gl, "no such function: %s", d->functions);
        return 0;
    }
    snprintf(head, sizeof head,
             "#version 330 core\nuniform %ssampler2D source;\nuniform uint first;\nout %s color;\n",
             reads_words ? "u" : "", words ? "uvec4" : "vec4");
    snprintf(body, sizeof body,
             "void main() {\n"
             "    ivec2 pixel = ivec2(gl_FragCoord.xy);\n"
             "    uint index = uint(pixel.x + pixel.y * %d) + first;\n"
             "    %s\n"
             "    color = %s;\n}\n",
             c->side,
             !reads        ? ""
             : reads_words ? "uvec4 w = texelFetch(source, pixel, 0);"
                           : "vec4 t = texelFetch(source, pixel, 0);",
             d->expression);
    return program_make(c->gl, &(ProgramText){.vertex = {"#version 330 core\n", screen_text},
                                              .fragment = {head, library, body}});
}

/* Compiles the program and sets its inputs. 0: see error. */
static GLuint prepare(Canvas *c, const Drawing *d, const Framebuffer *target)
{
    GLuint program = make_program(c, d, framebuffer_has_words(target, 0));
    if (!program) {
        snprintf(c->error, sizeof c->error, "%s", c->gl->error);
        return 0;
    }
    if (d->source || d->texture)
        texture_bind(c->gl, d->source ? d->source->colors[0] : d->texture, 0);
    c->gl->UseProgram(program);
    c->gl->Uniform1uiv(c->gl->GetUniformLocation(program, "first"), 1, &d->first);
    framebuffer_use(c->gl, target);
    return program;
}

static bool finish(Canvas *c, GLuint program)
{
    c->gl->DeleteProgram(program);
    bool drawn = gl_check(c->gl, "drawing an expression");
    if (!drawn)
        snprintf(c->error, sizeof c->error, "%s", c->gl->error);
    return drawn;
}

bool canvas_draw(Canvas *c, const Drawing *d, const Framebuffer *target)
{
    GLuint program = prepare(c, d, target);
    if (!program)
        return false;
    screen_draw(c->gl, &c->screen);
    return finish(c, program);
}

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + (double)time.tv_nsec * 1e-9;
}

double canvas_time(Canvas *c, const Drawing *d, const Framebuffer *target, int repeats)
{
    GLuint program = prepare(c, d, target);
    double least = 1e9;
    if (!program)
        return -1;
    for (int i = 0; i <= repeats; i++) {
        c->gl->Finish();
        double start = now();
        screen_draw(c->gl, &c->screen);
        c->gl->Finish();
        double took = now() - start;
        least = i && took < least ? took : least; /* the first draw includes compiling */
    }
    return finish(c, program) ? least : -1;
}
