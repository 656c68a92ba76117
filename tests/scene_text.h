/* Reads scenes from texts, for tests. */
#ifndef MATC_SCENE_TEXT_H
#define MATC_SCENE_TEXT_H
#include "runtime/scene_reader/scene_read.h"
#include "tests/test.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

#define RED "materials: { red: { material: RGBA, r: 1 } }\n"

/* Reads the scene of a text; NULL: *document has the messages. */
static inline Scene *read_text(const char *text, MatcDocument **document)
{
    Scene *scene = NULL;
    MatcOptions options;
    matc_options_init(&options);
    options.warnings = "no-no_light"; /* most texts are only read and never drawn */
    *document = scene_read("scene.yaml", text, strlen(text), &options, &scene);
    return scene;
}

/* Reads a text that must be a scene. */
static inline Scene *read_fine(const char *text, MatcDocument **document)
{
    Scene *scene = read_text(text, document);
    if (!scene)
        print_message("%s", matc_diagnostics(*document, MATC_TEXT));
    assert_non_null(scene);
    assert_string_equal(matc_diagnostics(*document, MATC_TEXT), "");
    return scene;
}

/* Reads a text that must be a scene, with the warning about too many triangles and no other. */
static inline Scene *read_heavy(const char *text, MatcDocument **document)
{
    Scene *scene = read_text(text, document);
    assert_non_null(scene);
    const char *reported = strstr(matc_diagnostics(*document, MATC_TEXT), "warning: ");
    assert_int_equal(matc_error_count(*document), 0);
    assert_true(reported && strstr(reported, "[-Wscene_heavy]") &&
                !strstr(reported + 1, "warning: "));
    return scene;
}

/* Checks that a text is refused as a scene, and its first message; NULL: any message. */
static inline void assert_fault(const char *text, const char *reported)
{
    MatcDocument *document;
    char line[512];
    assert_null(read_text(text, &document));
    const char *all = matc_diagnostics(document, MATC_TEXT);
    assert_int_not_equal(matc_error_count(document), 0);
    snprintf(line, sizeof line, "%.*s", (int)strcspn(all, "\n"), all);
    if (reported)
        assert_string_equal(line + strlen("scene.yaml:"), reported);
    matc_document_free(document);
}

static inline void forget(Scene *scene, MatcDocument *document)
{
    scene_free(scene);
    matc_document_free(document);
}

static inline void apply(const SceneMatrix *m, const double p[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = m->m[i] * p[0] + m->m[4 + i] * p[1] + m->m[8 + i] * p[2] + m->m[12 + i];
}

static inline void assert_near(const double *a, const double *b, int count, double within)
{
    for (int i = 0; i < count; i++)
        if (!(fabs(a[i] - b[i]) <= within)) {
            print_message("lane %d: %.17g, not %.17g\n", i, a[i], b[i]);
            fail();
        }
}

#endif
