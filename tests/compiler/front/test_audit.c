/* Coverage audit: which table rows occur in the tests that prove them, so that a new row without
 * a proof fails: maps, materials and their parameters, functions and values of formulas, library
 * definitions. Content of the examples is drawn and compared by test_value, differentiated by
 * test_slope and stored as goldens; test_tables tries every parameter, test_explain draws every
 * example of --explain, test_expression and test_formula cover every function. */
#include "tests/test.h"
#include "compiler/base/file.h"
#include "compiler/document.h"
#include "compiler/formula/formula.h"
#include "tests/stress/generate.h"
#include "tests/value/documents.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { STRESSED = 3000, LONGEST = 256 };

/* Rows that stand in some documents. */
typedef struct {
    bool kind[KIND_COUNT], param[PARAM_COUNT], term[TERM_COUNT], quantity[QUANTITY_COUNT];
} Seen;

/* A map and a material may have one name. */
static Kind kind_named(const char *name, bool material)
{
    Kind kind = KIND_COUNT;
    for (int i = 0; i < KIND_COUNT + alias_count + preset_count; i++) {
        const int alias = i - KIND_COUNT, preset = alias - alias_count;
        const char *other = alias < 0    ? kind_table[i].name
                            : preset < 0 ? alias_table[alias].alias
                                         : preset_table[preset].name;
        const Kind its = alias < 0    ? (Kind)i
                         : preset < 0 ? alias_table[alias].kind
                                      : preset_table[preset].kind;
        if (!strcmp(other, name) && (kind_table[its].lowering == LOWERING_MATERIAL) == material)
            kind = its;
    }
    return kind;
}

static void see_members(Seen *seen, Kind kind, const Tree *object)
{
    if (kind == KIND_COUNT)
        return;
    seen->kind[kind] = true;
    for (int i = kind_table[kind].first; i < kind_table[kind].first + kind_table[kind].count; i++)
        seen->param[i] |= tree_find(object, param_table[i].name) != NULL;
}

/* Records everything that is written, whatever becomes of it. */
static void see_tree(Seen *seen, const Tree *tree)
{
    if (tree->kind == TREE_list)
        for (uint32_t i = 0; i < tree->count; i++)
            see_tree(seen, tree->items[i]);
    for (uint32_t i = 0; tree->kind == TREE_object && i < tree->count; i++) {
        const Member *member = &tree->members[i];
        const bool map = !strcmp(member->key, "map"), material = !strcmp(member->key, "material");
        if (member->value->kind == TREE_scalar && (map || material))
            see_members(seen, kind_named(member->value->text, material), tree);
        see_tree(seen, member->value);
    }
}

static void see_formula(Seen *seen, const Formula *formula)
{
    for (size_t i = 0; i < formula->count; i++) {
        const FormulaStep *step = &formula->steps[i];
        if (step->kind == FORMULA_term)
            seen->term[step->row] = true;
        if (step->kind == FORMULA_value)
            seen->quantity[step->row] = true;
    }
}

static void see_node(Seen *seen, const Node *node, bool *been)
{
    if (!node || been[node->index])
        return;
    been[node->index] = true;
    seen->kind[node->kind] = true;
    for (int i = 0; i < kind_table[node->kind].count; i++) {
        const Value *value = &node->params[i];
        if (value->kind == VALUE_formula)
            see_formula(seen, value->formula);
        if (value->kind == VALUE_node)
            see_node(seen, value->node, been);
        for (int k = 0; value->kind == VALUE_items && k < value->items->count; k++)
            see_node(seen, value->items->item[k].input, been);
    }
}

static void see_document(Seen *seen, const MatcDocument *document)
{
    see_tree(seen, document->tree);
    bool *been = calloc((size_t)document->graph->node_count + 1, sizeof *been);
    assert_non_null(been);
    for (int i = 0; i < document->graph->material_count; i++)
        see_node(seen, document->graph->materials[i].node, been);
    free(been);
}

static void see_text(Seen *seen, const char *path, const char *text, size_t size,
                     const MatcOptions *options)
{
    MatcDocument *document = matc_read(path, text, size, options);
    for (int i = 0; i < QUANTITY_COUNT; i++) /* constants and attributes are other steps by then */
        seen->quantity[i] |= (!quantity_table[i].components || quantity_table[i].attribute) &&
                             strstr(text, quantity_table[i].name);
    if (document->graph && document->graph->node_count)
        see_document(seen, document);
    matc_document_free(document);
}

static void see_examples(Seen *seen)
{
    MatcOptions options;
    matc_options_init(&options);
    DocumentList list = documents_tried(SOURCE_FOLDER);
    for (int i = 0; i < list.count; i++) {
        size_t size;
        const char *why = NULL;
        char *text = file_read(list.paths[i], &size, &why);
        assert_non_null(text);
        see_text(seen, list.paths[i], text, size, &options);
        free(text);
    }
    documents_free(&list);
}

static void see_random(Seen *seen)
{
    MatcOptions options;
    matc_options_init(&options);
    options.read_file = generate_file;
    for (uint64_t i = 0; i < STRESSED; i++) {
        static Choices c;
        Arena arena = {0};
        Text text = text_new(&arena);
        choices_random(&c, 1, i);
        if (i % 4)
            generate_document(&c, &text);
        else
            generate_relief(&c, &text);
        see_text(seen, "stress.yaml", text.at, text.size, &options);
        arena_free(&arena);
    }
}

/* -- what is not seen */

static int missing;

static void expect(bool there, const char *where, const char *what, const char *row)
{
    if (there)
        return;
    print_error("%s: no %s %s\n", where, what, row);
    missing++;
}

/* All materials share the rows of displacement: one of them has it. */
static bool moved(const Seen *seen, const char *param)
{
    bool found = false;
    for (int i = 0; i < PARAM_COUNT; i++)
        found |= seen->param[i] && !strcmp(param_table[i].name, param);
    return found;
}

static bool moves(const char *param)
{
    return !strncmp(param, "displacement", strlen("displacement"));
}

/* Parameters of vertices only are judged by test_displacement and test_scene_volume; random
 * documents are judged at points. */
static bool is_of_vertices(const char *param)
{
    return !strcmp(param, "displacementBound") || !strcmp(param, "displacementVolume") ||
           !strcmp(param, "displacementThreshold");
}

static void expect_all(const Seen *seen, const char *where, bool vertices)
{
    char name[LONGEST];
    for (int i = 0; i < KIND_COUNT; i++)
        expect(seen->kind[i] || i == KIND_Constant, where, "kind", kind_table[i].name);
    for (int i = 0; i < PARAM_COUNT; i++) {
        snprintf(name, sizeof name, "%s.%s", kind_table[param_table[i].kind].name,
                 param_table[i].name);
        const bool there =
            moves(param_table[i].name) ? moved(seen, param_table[i].name) : seen->param[i];
        expect(there || param_table[i].kind == KIND_Constant ||
                   (!vertices && is_of_vertices(param_table[i].name)),
               where, "parameter", name);
    }
    for (int i = 0; i < TERM_COUNT; i++)
        expect(seen->term[i], where, "term", term_table[i].name);
    for (int i = 0; i < QUANTITY_COUNT; i++)
        expect(seen->quantity[i], where, "value", quantity_table[i].name);
}

static void examples_have_all(void **state)
{
    (void)state;
    Seen seen = {0};
    see_examples(&seen);
    missing = 0;
    expect_all(&seen, "examples", true);
    assert_int_equal(missing, 0);
}

static void random_documents_have_all(void **state)
{
    (void)state;
    Seen seen = {0};
    see_random(&seen);
    missing = 0;
    expect_all(&seen, "random documents", false);
    assert_int_equal(missing, 0);
}

/* -- areas, schema, pages */

/* Kinds that need no mean: constants, normals, and kinds that sample their input themselves
 * (test_filtered). */
static bool needs_no_area(Kind kind)
{
    static const Kind kinds[] = {KIND_Constant,  KIND_RGBColor, KIND_Graytone, KIND_BumpMap,
                                 KIND_NormalMap, KIND_WaveMap,  KIND_Smooth3D, KIND_Laplace3D};
    bool found = kind_table[kind].lowering == LOWERING_MATERIAL;
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        found |= kinds[i] == kind;
    return found;
}

static bool names_map(const char *text, const char *name)
{
    char start[LONGEST];
    const int size = snprintf(start, sizeof start, "map: %s", name);
    bool found = false;
    for (const char *at = text; !found && (at = strstr(at, start)); at += size)
        found = at[size] == ' ' || at[size] == ',';
    return found;
}

static void means_of_all_maps_are_judged(void **state)
{
    (void)state;
    size_t size;
    const char *why = NULL;
    char *rows = file_read(SOURCE_FOLDER "/tests/areas.def", &size, &why);
    assert_non_null(rows);
    missing = 0;
    for (int i = 0; i < KIND_COUNT; i++)
        expect(needs_no_area((Kind)i) || names_map(rows, kind_table[i].name), "areas.def", "row of",
               kind_table[i].name);
    free(rows);
    assert_int_equal(missing, 0);
}

static void expect_quoted(const char *text, const char *where, const char *what, const char *name)
{
    char quoted[LONGEST];
    snprintf(quoted, sizeof quoted, "\"%s\"", name);
    expect(strstr(text, quoted) != NULL, where, what, name);
}

static void schemas_have_all(void **state)
{
    (void)state;
    char *schema = matc_schema("document");
    assert_non_null(schema);
    missing = 0;
    for (int i = 0; i < KIND_COUNT; i++)
        expect(i == KIND_Constant || strstr(schema, kind_table[i].name), "schema", "kind",
               kind_table[i].name);
    for (int i = 0; i < PARAM_COUNT; i++)
        if (param_table[i].kind != KIND_Constant)
            expect_quoted(schema, "schema", "parameter", param_table[i].name);
    free(schema);
    assert_int_equal(missing, 0);
}

static void expect_page(const char *name, const char *what)
{
    char *page = matc_explain(name);
    expect(page != NULL, "pages", what, name);
    free(page);
}

static void pages_have_all(void **state)
{
    (void)state;
    missing = 0;
    for (int i = 0; i < KIND_COUNT; i++)
        expect_page(kind_table[i].name, "kind");
    for (int i = 0; i < TERM_COUNT; i++)
        if (term_table[i].callable)
            expect_page(term_table[i].name, "function");
    for (int i = 0; i < QUANTITY_COUNT; i++)
        expect_page(quantity_table[i].name, "value");
    for (int i = 0; i < SPECIAL_COUNT; i++)
        expect_page(formula_special_table[i].name, "function");
    for (int i = 0; i < vector_count; i++)
        expect_page(vector_table[i].name, "function");
    assert_int_equal(missing, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(examples_have_all), cmocka_unit_test(random_documents_have_all),
        cmocka_unit_test(means_of_all_maps_are_judged), cmocka_unit_test(schemas_have_all),
        cmocka_unit_test(pages_have_all)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
