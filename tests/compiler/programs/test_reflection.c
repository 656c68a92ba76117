/* The reflection against the program itself: every example, passes, layouts and targets, by
 * glslang's SPIR-V of the program and by OpenGL's queries of the linked program. */
/* ctest: seconds=18 */
#include "tests/test.h"
#include "runtime/gl/backend.h"
#include "runtime/gl/program.h"
#include "tests/value/documents.h"
#include "tests/value/facts.h"
#include <stdio.h>
#include <string.h>

#define BLOCK "Material"

enum { MAX_SHOWN = 5, LONGEST = 512 };

typedef struct {
    GlContext *core, *old;
    Facts reported, reported_vertex, found;
    int programs, facts, dropped, failures;
} Test;

static void fault(Test *t, const char *where, const char *what, const Fact *fact)
{
    if (t->failures++ < MAX_SHOWN)
        print_error("%s: %s: %s %s %s, place %d, size %d\n", where, what, fact_kinds[fact->kind],
                    fact->type, fact->name, fact->place, fact->size);
}

/* Every fact of one list is in the other, and says the same; a place or type that either does not
 * tell is any. */
static void compare(Test *t, const char *where, const Facts *facts, const Facts *others,
                    const char *missing)
{
    for (int i = 0; i < facts->count; i++) {
        const Fact *fact = &facts->at[i], *other = facts_find(others, fact->kind, fact->name);
        t->facts++;
        if (!other) {
            fault(t, where, missing, fact);
            continue;
        }
        bool placed =
            fact->place == NO_PLACE || other->place == NO_PLACE || fact->place == other->place;
        bool typed = !*fact->type || !*other->type || !strcmp(fact->type, other->type);
        if (!placed || !typed || fact->size != other->size) {
            fault(t, where, "is", fact);
            fault(t, where, "but is", other);
        }
    }
}

/* A target with locations tells all of them. */
static void check_reported(Test *t, const char *where, const Facts *reported)
{
    for (int i = 0; i < reported->count; i++)
        if (reported->at[i].kind != FACT_system && reported->at[i].place == NO_PLACE)
            fault(t, where, "no place is told", &reported->at[i]);
}

static bool is_bound(const Fact *fact)
{
    return fact->kind == FACT_block || fact->kind == FACT_texture;
}

/* Both programs of a pipeline share one set: no two resources are at one binding. */
static void check_bindings(Test *t, const char *where)
{
    const Fact *seen[FACT_CAPACITY] = {NULL};
    const Facts *shaders[] = {&t->reported, &t->reported_vertex};
    for (int shader = 0; shader < 2; shader++)
        for (int i = 0; i < shaders[shader]->count; i++) {
            const Fact *fact = &shaders[shader]->at[i];
            if (!is_bound(fact) || fact->place < 0 || fact->place >= FACT_CAPACITY)
                continue;
            if (seen[fact->place])
                fault(t, where, "at a binding that another has", fact);
            seen[fact->place] = fact;
        }
}

/* Facts without the block of uniforms that the vertex program alone has, which displaces by them
 * where the fragment program computes nothing. */
static Facts without_vertex_block(const Facts *reported, const Facts *found, const char *vertex)
{
    const bool displaces =
        !facts_find(found, FACT_block, BLOCK) && strstr(vertex, "uniform " BLOCK " {");
    Facts kept = *reported;
    kept.count = 0;
    for (int i = 0; i < reported->count; i++)
        if (!displaces || strncmp(reported->at[i].name, BLOCK, strlen(BLOCK)) != 0)
            kept.at[kept.count++] = reported->at[i];
    return kept;
}

static void check_spirv(Test *t, const char *where, const MatcProgram *program)
{
    size_t bytes;
    const uint32_t *words =
        (const uint32_t *)(const void *)matc_output(program, MATC_SPIRV, &bytes);
    if (!words || !facts_of_spirv(words, bytes, &t->found))
        fail_msg("%s: no module, or a resource outside of set 0", where);
    check_reported(t, where, &t->reported);
    check_reported(t, where, &t->reported_vertex);
    check_bindings(t, where);
    const Facts own =
        without_vertex_block(&t->reported, &t->found, matc_output(program, MATC_VERTEX, NULL));
    compare(t, where, &own, &t->found, "told, but not in the SPIR-V");
    compare(t, where, &t->found, &t->reported, "in the SPIR-V, but not told");
}

/* The text declares it, though the driver has found no use for it. */
static bool is_declared(const char *text, const Fact *fact)
{
    char declaration[LONGEST];
    snprintf(declaration, sizeof declaration, "%s %s;", fact->type, fact->name);
    return strstr(text, declaration) != NULL;
}

/* Inputs that the driver dropped cannot be compared, but stand in the text. */
static void check_kept(Test *t, const char *where, const Facts *reported, const char *text)
{
    for (int i = 0; i < reported->count; i++) {
        const Fact *fact = &reported->at[i];
        bool asked = fact->kind == FACT_uniform || fact->kind == FACT_texture ||
                     fact->kind == FACT_attribute;
        if (asked && !facts_find(&t->found, fact->kind, fact->name)) {
            t->dropped++;
            if (!is_declared(text, fact))
                fault(t, where, "told, but not in the text", fact);
        }
        if (fact->kind == FACT_input && !is_declared(text, fact))
            fault(t, where, "told, but not in the text", fact);
    }
}

static FactsProc load(void *state, const char *name) { return gl_backend_osmesa.load(state, name); }

static void check_linked(Test *t, const char *where, const MatcProgram *program, bool old)
{
    static Facts all;
    GlContext *gl = old ? t->old : t->core;
    const char *fragment = matc_output(program, MATC_FRAGMENT, NULL),
               *vertex = matc_output(program, MATC_VERTEX, NULL);
    assert_true(gl_use(gl));
    GLuint name = program_make(gl, &(ProgramText){.vertex = {vertex}, .fragment = {fragment}});
    if (!name)
        fail_msg("%s: %s", where, gl->error);
    facts_of_program(gl, name, load, &t->found);
    gl->DeleteProgram(name);
    all = t->reported;
    for (int i = 0; i < t->reported_vertex.count; i++)
        all.at[all.count++] = t->reported_vertex.at[i];
    compare(t, where, &t->found, &all, "in the linked program, but not told");
    check_kept(t, where, &t->reported, fragment);
    check_kept(t, where, &t->reported_vertex, vertex);
}

typedef struct {
    const char *target, *pass, *layout, *constants, *noise;
} Way;

static void check(Test *t, const Document *document, int material, const Way *way)
{
    char where[LONGEST];
    MatcOptions options = document->options;
    options.target = way->target;
    options.pass = way->pass;
    options.layout = way->layout;
    options.constants = way->constants;
    options.noise = way->noise;
    bool spirv = !strcmp(way->target, "spirv"), located = spirv || !strcmp(way->target, "glsl450");
    const unsigned outputs =
        MATC_REFLECT | MATC_VERTEX | (spirv ? 0 : MATC_FRAGMENT) | (located ? MATC_SPIRV : 0);
    snprintf(where, sizeof where, "%s, --target=%s --pass=%s --layout=%s --constants=%s --noise=%s",
             document_name(document), way->target, way->pass, way->layout, way->constants,
             way->noise);
    MatcProgram *program = matc_compile(document->document, material, outputs, &options);
    if (!matc_ok(program))
        fail_msg("%s: %s", where, matc_program_diagnostics(program, MATC_TEXT));
    assert_true(facts_of_reflection(matc_output(program, MATC_REFLECT, NULL), &t->reported,
                                    &t->reported_vertex));
    t->programs++;
    if (located)
        check_spirv(t, where, program);
    if (!spirv)
        check_linked(t, where, program, !strcmp(way->target, "glsl110"));
    matc_program_free(program);
}

/* Every example comes in several ways, and every way to many of them. */
static const Way ways[] = {
    {"spirv", "gbuffer", "compact", "uniform", "lattice"},
    {"spirv", "gbuffer", "integer", "baked", "groimp"},
    {"spirv", "plane", "thesis", "uniform", "lattice"},
    {"spirv", "sky", "compact", "baked", "lattice"},
    {"spirv", "shadow", "compact", "uniform", "groimp"},
    {"spirv", "depth", "compact", "baked", "lattice"},
    {"glsl450", "gbuffer", "radix", "uniform", "groimp"},
    {"glsl450", "plane", "compact", "baked", "lattice"},
    {"glsl330", "gbuffer", "thesis", "uniform", "groimp"},
    {"glsl330", "sky", "compact", "uniform", "lattice"},
    {"glsl110", "gbuffer", "thin", "uniform", "groimp"},
    {"glsl110", "plane", "thesis", "baked", "lattice"},
    {"essl300", "gbuffer", "compact", "uniform", "groimp"},
};
enum { WAYS = sizeof ways / sizeof *ways, EACH = 3 };

static Test test;

static int set_up(void **state)
{
    (void)state;
    char error[LONGEST];
    test.core = gl_open(GL_KIND_osmesa, true, error, sizeof error);
    test.old = gl_open(GL_KIND_osmesa, false, error, sizeof error);
    return !test.core || !test.old;
}

static int tear_down(void **state)
{
    (void)state;
    gl_close(test.core);
    gl_close(test.old);
    return 0;
}

static void reflections_are_true(void **state)
{
    (void)state;
    DocumentList list = documents_list(SOURCE_FOLDER);
    for (int i = 0, way = 0; i < list.count; i++) {
        Document document;
        bool fine = document_open(&document, list.paths[i]);
        if (!fine && !document_is_library(&document))
            fail_msg("%s", document_fault(&document));
        for (int material = 0; fine && material < matc_material_count(document.document);
             material++)
            for (int k = 0; k < EACH; k++)
                check(&test, &document, material, &ways[way++ % WAYS]);
        document_close(&document);
    }
    documents_free(&list);
    print_message("%d programs, %d facts, %d dropped by the driver\n", test.programs, test.facts,
                  test.dropped);
    assert_int_equal(test.failures, 0);
}

/* More textures than there are bindings below those of the blocks. */
static void many_textures_are_apart(void **state)
{
    (void)state;
    enum { RELIEFS = 24 };
    char text[RELIEFS * 64 + LONGEST];
    int size =
        snprintf(text, sizeof text,
                 "material: Phong\ndiffuse: { map: Blend, input: { map: Gradient }, blend: [\n");
    for (int i = 0; i < RELIEFS; i++)
        size += snprintf(
            text + size, sizeof text - (size_t)size,
            "  { value: %d, input: { map: Carpenter, width: 4, height: 4, seed: %d } },\n", i, i);
    snprintf(text + size, sizeof text - (size_t)size, "] }\n");
    Document document;
    if (!document_open_text(&document, text))
        fail_msg("%s", document_fault(&document));
    test.failures = 0;
    check(&test, &document, 0, &(Way){"spirv", "gbuffer", "compact", "uniform", "groimp"});
    document_close(&document);
    assert_int_equal(test.failures, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reflections_are_true),
        cmocka_unit_test(many_textures_are_apart),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
