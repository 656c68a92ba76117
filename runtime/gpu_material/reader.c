/* Reads slots from a G-buffer. One program serves all slots: the uniform reader_slot selects the
 * slot to draw. For a layout of two slots, in GLSL 3.30:
 *   uniform int reader_slot;
 *   layout(location = 0) out vec4 value;
 *   void main()
 *   {
 *       Surface s = unpackSurface(ivec2(gl_FragCoord.xy));
 *       value = vec4(0.0);
 *       if (reader_slot == 0)
 *           value = vec4(s.normal, 0.0);
 *       if (reader_slot == 3)
 *           value = vec4(s.shininess, 0.0, 0.0, 0.0);
 *   } */
#include "runtime/gpu_material/reader.h"
#include <stdio.h>

enum { HEAD_CAPACITY = 256, MAIN_CAPACITY = 8192 };

static bool is_old(const ReaderSource *source) { return !target_table[source->target].in_out; }

static void write_head(const ReaderSource *source, char text[HEAD_CAPACITY])
{
    const TargetRow *row = &target_table[source->target];
    snprintf(text, HEAD_CAPACITY, "#version %s\n%s", row->version,
             row->precision
                 ? "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n"
                 : "");
}

static void write_main(const ReaderSource *source, char text[MAIN_CAPACITY])
{
    static const char *const fill[] = {"", ", 0.0, 0.0, 0.0", ", 0.0, 0.0", ", 0.0", ""};
    const char *value = is_old(source) ? "gl_FragColor" : "value";
    size_t size = 0;
#define PUT(...)                                                                                   \
    (size +=                                                                                       \
     (size_t)snprintf(text + size, size < MAIN_CAPACITY ? MAIN_CAPACITY - size : 0, __VA_ARGS__))
    PUT("\nuniform int reader_slot;\n%svoid main() {\n",
        is_old(source) ? "" : "layout(location = 0) out vec4 value;\n");
    if (is_old(source))
        PUT("    Surface s = unpackSurface(gl_FragCoord.xy / vec2(%d.0, %d.0));\n", source->width,
            source->height);
    else
        PUT("    Surface s = unpackSurface(ivec2(gl_FragCoord.xy));\n");
    PUT("    %s = vec4(0.0);\n", value);
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        /* a slot of unused cases has its absent value */
        if (layout_has_slot(source->layout, (Slot)slot)) {
            const int components = type_table[slot_table[slot].type].components;
            const int none = (int)slot_table[slot].absent; /* all absent values are integers */
            PUT("#ifdef SURFACE_HAS_%s\n    if (reader_slot == %d) %s = vec4(s.%s%s);\n#else\n",
                slot_table[slot].name, slot, value, slot_table[slot].name, fill[components]);
            PUT("    if (reader_slot == %d) %s = vec4(%d.0, vec3(%d.0) * vec3(%d, %d, "
                "%d));\n#endif\n",
                slot, value, none, none, components > 1, components > 2, components > 3);
        }
    PUT("}\n");
#undef PUT
}

static bool make(Store *store, const ReaderSource *source, Reader *r)
{
    char head[HEAD_CAPACITY], body[MAIN_CAPACITY];
    write_head(source, head);
    write_main(source, body);
    const ProgramText text = {.vertex = {head, is_old(source) ? screen_text_old : screen_text},
                              .fragment = {head, source->unpack, body}};
    const FramebufferSpec spec = {source->width, source->height, 1, GL_RGBA32F, false};
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        r->holds[slot] = layout_has_slot(source->layout, (Slot)slot);
    return material_make(store, NULL, &text, &r->program) &&
           screen_make(store_context(store), &r->screen) &&
           framebuffer_make(store_context(store), &spec, &r->values);
}

bool reader_make(Store *store, const ReaderSource *source, Reader *made)
{
    *made = (Reader){0};
    if (make(store, source, made))
        return true;
    made->program.store =
        store; /* reader_delete() reads the store, also if making the program failed */
    reader_delete(made);
    return false;
}

void reader_delete(Reader *r)
{
    const Store *store = r->program.store;
    if (!store)
        return;
    screen_delete(store_context(store), &r->screen);
    framebuffer_delete(store_context(store), &r->values);
    material_delete(&r->program);
    *r = (Reader){0};
}

bool reader_read(Reader *r, const Framebuffer *gbuffer, Slot slot, float *rgba)
{
    GlContext *gl = store_context(r->program.store);
    material_set_number(&r->program, "reader_slot", (float)slot);
    framebuffer_use(gl, &r->values);
    targets_read(gbuffer, &r->program);
    screen_draw(gl, &r->screen);
    return framebuffer_read(gl, &r->values, 0, rgba);
}
