/* Every row of foreign.def, written in a document as an author of another tool would: the first
 * line of the message, and --explain, give the name used here. */
#include "tests/test.h"
#include "compiler/matc.h"
#include "grammar/foreign_table.h"
#include "grammar/library_table.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST_DOCUMENT = 512, MAX_WAYS = 4 };

/* The messages of a document hold a text. */
static bool says(const char *text, const char *here)
{
    MatcOptions options;
    matc_options_init(&options);
    MatcDocument *document = matc_read("case.yaml", text, strlen(text), &options);
    const bool reported =
        matc_error_count(document) && strstr(matc_diagnostics(document, MATC_TEXT), here);
    matc_document_free(document);
    return reported;
}

/* The i-th document with the row; false: there are no more. */
static bool write_document(const ForeignRow *row, int i, char text[LONGEST_DOCUMENT])
{
    static const char *const formulas[MAX_WAYS] = {"%s", "%s(1, 1)", "1 %s 1", "%s 1"};
    char formula[LONGEST_DOCUMENT / 2];
    const char *kind = row->kind < KIND_COUNT ? kind_table[row->kind].name : "", *form = "";
    const bool material =
        row->kind < KIND_COUNT && kind_table[row->kind].lowering == LOWERING_MATERIAL;
    switch (row->group) {
    case FOREIGN_MAP:
        form = "material: Phong\ndiffuse: { map: %s }\n";
        break;
    case FOREIGN_MATERIAL:
        form = "material: %s\n";
        break;
    case FOREIGN_KEY:
        form = "material: Phong\n%s: 1\n";
        break;
    case FOREIGN_TOP:
        form = "materials: { a: { material: Phong } }\n%s: 1\n";
        break;
    case FOREIGN_TYPE:
        form = "%s: Phong\n";
        break;
    case FOREIGN_SCENE:
        form = "objects: [{ object: %s }]\n";
        break;
    case FOREIGN_PLACE:
        form = "objects: [{ object: Sphere, %s: 1 }]\n";
        break;
    case FOREIGN_COLOR:
        form = "material: Phong\ndiffuse: %s\n";
        break;
    case FOREIGN_FORM:
        form = "material: Principled\nbaseColor: %s\n";
        break;
    case FOREIGN_PARAM:
        snprintf(text, LONGEST_DOCUMENT,
                 material ? "material: %s\n%s: 1\n"
                          : "material: Phong\ndiffuse: { map: %s, %s: 1 }\n",
                 kind, row->name);
        return i < 1;
    case FOREIGN_FORMULA:
        if (i == MAX_WAYS)
            return false;
        snprintf(formula, sizeof formula, formulas[i], row->name);
        snprintf(text, LONGEST_DOCUMENT, "material: Phong\ndiffuse: \"= %s\"\n", formula);
        return true;
    }
    snprintf(text, LONGEST_DOCUMENT, form, row->written ? row->written : row->name);
    return i < 1;
}

static void every_row_is_met_in_a_document(void **state)
{
    (void)state;
    int faults = 0;
    for (int i = 0; i < foreign_count; i++) {
        const ForeignRow *row = &foreign_table[i];
        char text[LONGEST_DOCUMENT];
        bool reported = false;
        for (int way = 0; !reported && write_document(row, way, text); way++)
            reported = says(text, row->group == FOREIGN_TYPE ? "`material: Phong`" : row->here);
        if (!reported)
            print_error("no message says '%s' of\n%s", row->here, text);
        faults += !reported;
    }
    print_message("%d rows\n", foreign_count);
    assert_true(foreign_count > 400);
    assert_int_equal(faults, 0);
}

static void every_row_is_explained(void **state)
{
    (void)state;
    for (int i = 0; i < foreign_count; i++) {
        char *page = matc_explain(foreign_table[i].name);
        if (!page || !strstr(page, foreign_table[i].here))
            fail_msg("--explain %s lacks '%s'", foreign_table[i].name, foreign_table[i].here);
        free(page);
    }
}

/* Differences in case and signs count for nothing, but in formulas. */
static void names_are_compared_loosely(void **state)
{
    (void)state;
    assert_true(says("material: Principled\nBase-Metalness: 1\n", "; here it is metalness"));
    assert_true(says("material: Principled\nbase_metalness: 1\n", "; here it is metalness"));
    assert_true(says("material: Phong\ndiffuse: Dark Brown\n", "; here it is \"#5c4033\""));
    assert_null(foreign_name(FOREIGN_FORMULA, KIND_COUNT, "Lerp"));
}

/* Names of the library, without its file, with another one, and with a name that is almost the
 * file's. */
static void the_library_is_found(void **state)
{
    (void)state;
    char text[LONGEST_DOCUMENT], hint[LONGEST_DOCUMENT];
    assert_true(library_name_count >= 20);
    for (int i = 0; i < library_name_count; i++) {
        const LibraryName *row = &library_names[i];
        snprintf(hint, sizeof hint, "; it comes with matc: `include: %s`", row->file);
        snprintf(text, sizeof text, "material: Phong\ndiffuse: { ref: %s }\n", row->name);
        assert_true(says(text, hint));
        snprintf(text, sizeof text, "include: %s\nmaterial: Phong\ndiffuse: { ref: %s }\n",
                 strcmp(row->file, "tiles.yaml") ? "tiles.yaml" : "bricks.yaml", row->name);
        assert_true(says(text, hint));
        snprintf(text, sizeof text, "material: Phong\ndiffuse: { map: %s }\n", row->name);
        snprintf(hint, sizeof hint,
                 "it is a definition, write `{ ref: %s }`; it comes with matc: `include: %s`",
                 row->name, row->file);
        assert_true(says(text, hint));
        snprintf(text, sizeof text, "include: %s\nmaterial: Phong\ndiffuse: { map: %s }\n",
                 row->file, row->name);
        snprintf(hint, sizeof hint, "'; it is a definition, write `{ ref: %s }`\n", row->name);
        assert_true(says(text, hint));
        char *page = matc_explain(row->name), *list = matc_list_of("library");
        snprintf(hint, sizeof hint, "include: %s", row->file);
        assert_non_null(page);
        assert_non_null(list);
        assert_true(strstr(page, hint) && strstr(page, row->doc) && strstr(list, row->doc));
        free(page);
        free(list);
    }
    assert_true(
        says("include: bricks\nmaterial: Phong\n", "; did you mean the file 'bricks.yaml'?"));
    assert_true(says("include: brick.yaml\nmaterial: Phong\n", "; did you mean 'bricks.yaml'?"));
    assert_true(says("include: rustiness\nmaterial: Phong\n", "; 'rustiness' is in 'rust.yaml'"));
}

/* Pages of keys: of which kinds they are, and all their choices. */
static void keys_are_explained(void **state)
{
    (void)state;
    static const char *const pages[][3] = {{"baseColor", "of Principled\n", "of other tools"},
                                           {"objects", "of Scene\n", "The visible objects."},
                                           {"transform", "of XYZTransform\n", "of Plane\n"},
                                           {"metallic", "of UsdPreview\n", "here it is metalness"},
                                           {"address", "  mirror ", "  border "},
                                           {"preset", "  thesisBuddha ", "  thesisMarch "},
                                           {"quality", "  draft ", "  fine "},
                                           {"thesisMarch", "choice of preset", "12 rays"},
                                           {"method", "  hybrid ", "  bisection "}};
    for (size_t i = 0; i < sizeof pages / sizeof *pages; i++) {
        char *page = matc_explain(pages[i][0]);
        if (!page || !strstr(page, pages[i][1]) || !strstr(page, pages[i][2]))
            fail_msg("--explain %s:\n%s", pages[i][0], page ? page : "nothing");
        free(page);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_row_is_met_in_a_document), cmocka_unit_test(every_row_is_explained),
        cmocka_unit_test(names_are_compared_loosely), cmocka_unit_test(the_library_is_found),
        cmocka_unit_test(keys_are_explained)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
