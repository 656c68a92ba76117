/* No program has an implicit derivative in non-uniform control flow: every example, through
 * every pass and target. glslang compiles the text to SPIR-V, whose blocks are walked. */
/* ctest: unsanitized seconds=60 */
#include "tests/test.h"
#include "compiler/choice.h"
#include "tests/value/documents.h"
#include "tests/value/share.h"
#include "tests/value/spirv_flow.h"
#include "tests/value/workers.h"
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SHARES = 6 /* tests/value/share.h */ };

/* -- the walk itself, by programs whose derivatives are counted by hand */

static void conditions_are_seen(void **state)
{
    (void)state;
    static const char head[] = "#version 330 core\nuniform sampler2D s;\nin vec2 uv;\nin float "
                               "t;\nlayout(location = 0) out vec4 c;\n"
                               "vec4 read(vec2 p) { return texture(s, p); }\n"
                               "float same(float x) { if (x > 0.5) return x; return 1.0; }\n"
                               "void leave(float x) { if (x > 0.5) discard; }\n";
    static const struct {
        const char *body;
        int conditional, derivatives;
    } rows[] = {
        {"c = texture(s, uv);", 0, 1},
        {"c = read(uv);", 0, 1},
        {"c = texture(s, uv); c *= same(t); c += dFdx(t);", 0, 2},
        {"if (t > 0.0) c = texture(s, uv); else c = vec4(0.0);", 1, 1},
        {"if (t > 0.0) c = textureGrad(s, uv, dFdx(uv), vec2(0.0));", 1, 1},
        {"if (t > 0.0) c = textureLod(s, uv, 0.0) + texelFetch(s, ivec2(uv), 0);", 0, 0},
        {"c = t > 0.0 ? read(uv) : vec4(0.0);", 1, 1},
        {"bool b = t > 0.0 && texture(s, uv).x > 0.5; c = vec4(b);", 1, 1},
        {"c = vec4(0.0); for (float i = 0.0; i < t; i += 1.0) c += texture(s, uv + i);", 1, 1},
        {"if (t > 0.0) discard; c = texture(s, uv);", 1, 1},
        {"c = texture(s, uv); if (c.w < 0.5) discard;", 0, 1},
        {"if (t > 0.0) return; c = vec4(fwidth(t));", 1, 1},
        {"leave(t); c = texture(s, uv);", 1, 1},
        {"if (t > 0.0) { if (t > 0.5) c = vec4(1.0); c += dFdy(t); } c += dFdx(t);", 1, 2},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char text[2048];
        int derivatives = 0;
        snprintf(text, sizeof text, "%svoid main() { %s }\n", head, rows[i].body);
        const int conditional = glsl_conditional_derivatives(text, &derivatives);
        if (conditional != rows[i].conditional || derivatives != rows[i].derivatives)
            fail_msg("%s: %d of %d, and not %d of %d", rows[i].body, conditional, derivatives,
                     rows[i].conditional, rows[i].derivatives);
    }
}

/* -- what matc emits */

typedef struct {
    DocumentList documents;
    atomic_int next, programs, derivatives, faults;
} Run;

static bool has_derivatives(const char *text)
{
    return strstr(text, "texture(") || strstr(text, "texture2D(") || strstr(text, "dFd") ||
           strstr(text, "fwidth");
}

/* GLSL 1.10 has no texelFetch: tables and texels come by texture2D from textures without
 * mipmaps, whose level is 0 whatever the derivative. Only imageSampled and imageCentred read a
 * texture with mipmaps. The other calls are rewritten with a level. */
static char *with_levels(const char *text)
{
    static const char by_level[] = "#version 110\n#extension GL_ARB_shader_texture_lod : enable\n";
    const size_t size = 2 * strlen(text) + sizeof by_level;
    char *made = calloc(size, 1), *to = made + strlen(strcpy(made, by_level));
    bool mipmaps = false;
    assert_true(!strncmp(text, "#version 110\n", 13));
    for (text += 13; *text;) {
        if (!strncmp(text, "vec4 image", 10))
            mipmaps = !strncmp(text + 10, "Sampled(", 8) || !strncmp(text + 10, "Centred(", 8);
        if (!strncmp(text, "}\n", 2))
            mipmaps = false;
        const bool read = !mipmaps && !strncmp(text, "texture2D(", 10);
        const char *end = read ? text + 10 : text + 1;
        for (int depth = read; depth > 0; end++)
            depth += (*end == '(') - (*end == ')');
        if (read)
            to += sprintf(to, "texture2DLod(%.*s, 0.0)", (int)(end - text - 11), text + 10);
        else
            *to++ = *text;
        text = end;
    }
    return made;
}

static void check_program(Run *run, const Document *d, int material, const MatcOptions *options)
{
    MatcProgram *program = matc_compile(d->document, material, MATC_FRAGMENT, options);
    const char *text = matc_output(program, MATC_FRAGMENT, NULL);
    int derivatives = 0, conditional = 0;
    char *rewritten = text && !strcmp(options->target, "glsl110") ? with_levels(text) : NULL;
    if (text && has_derivatives(text))
        conditional = glsl_conditional_derivatives(rewritten ? rewritten : text, &derivatives);
    free(rewritten);
    atomic_fetch_add(&run->programs, 1);
    atomic_fetch_add(&run->derivatives, derivatives);
    if (conditional != 0) {
        atomic_fetch_add(&run->faults, 1);
        fprintf(stderr, "%s %s, %s, pass %s, -O%d%s: %d implicit derivatives in conditions\n",
                document_name(d), matc_material_name(d->document, material), options->target,
                options->pass, options->optimize, options->instances ? ", instances" : "",
                conditional);
    }
    matc_program_free(program);
}

/* Means over the pixel come by pictures' samplers with `auto`, which alone leaves the footprint
 * to the driver. */
static void check_material(Run *run, const Document *d, int material)
{
    MatcOptions options = d->options;
    for (int i = 0; i < TARGET_COUNT * PASS_COUNT * 2 * 2; i++) {
        const int target = i % TARGET_COUNT, pass = i / TARGET_COUNT % PASS_COUNT,
                  rest = i / TARGET_COUNT / PASS_COUNT;
        options.target = target_table[target].name;
        options.pass = pass_table[pass].name;
        options.optimize = rest % 2 ? 0 : 2;
        options.instances = rest / 2;
        if (share_takes(i, SHARES) && (options.optimize || target == TARGET_DEFAULT) &&
            (!options.instances || target_table[target].storage))
            check_program(run, d, material, &options);
    }
}

static void *work(void *user)
{
    Run *run = user;
    for (int i; (i = atomic_fetch_add(&run->next, 1)) < run->documents.count;) {
        Document document;
        const char *only = getenv("VALUE_ONLY");
        if (only && !strstr(run->documents.paths[i], only))
            continue;
        const bool good = document_open(&document, run->documents.paths[i]);
        for (int material = 0; good && material < matc_material_count(document.document);
             material++)
            check_material(run, &document, material);
        document_close(&document);
    }
    return NULL;
}

static void examples_derive_unconditionally(void **state)
{
    (void)state;
    Run run = {.documents = documents_tried(SOURCE_FOLDER)};
    workers_run(work, &run);
    documents_free(&run.documents);
    print_message("%d programs, %d implicit derivatives\n", run.programs, run.derivatives);
    /* A run that hardly tests anything fails; the smallest of SHARES shares has 900 of each. */
    assert_true(run.programs > 3000 / SHARES && run.derivatives > 3000 / SHARES);
    assert_int_equal(run.faults, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(conditions_are_seen),
        cmocka_unit_test(examples_derive_unconditionally),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
