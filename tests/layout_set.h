/* Documents, the possible values of their materials, and the layout made for them. */
#ifndef TESTS_LAYOUT_SET_H
#define TESTS_LAYOUT_SET_H
#include "compiler/document.h"
#include "compiler/layout/auto_layout.h"
#include "compiler/layout/custom.h"
#include "tests/value/documents.h"
#include <stdio.h>
#include <string.h>

enum { MAX_DOCUMENTS = 32 };

typedef struct {
    Document documents[MAX_DOCUMENTS];
    int count;
    MatcRanges ranges;
    MatcLayout *layout;
} MaterialSet;

static inline void add_material(MatcRanges *ranges, const MatcDocument *document, int material,
                                const MatcOptions *options)
{
    char *fault;
    if (!matc_ranges_add(ranges, document, material, options, &fault))
        fail_msg("%s", fault);
}

static inline void set_open(MaterialSet *set, const char *const *paths, int count, double error)
{
    *set = (MaterialSet){.count = count};
    matc_ranges_init(&set->ranges);
    for (int i = 0; i < count; i++) {
        char path[512];
        Document *d = &set->documents[i];
        snprintf(path, sizeof path, SOURCE_FOLDER "/%s", paths[i]);
        if (!document_open(d, path))
            fail_msg("%s: %s", path, document_fault(d));
        for (int k = 0; k < d->graph->material_count; k++)
            add_material(&set->ranges, d->document, k, &d->options);
    }
    set->layout = matc_layout_for(&set->ranges, error, &set->documents[0].options);
    assert_true(matc_layout_ok(set->layout));
}

static inline void set_close(MaterialSet *set)
{
    matc_layout_free(set->layout);
    for (int i = 0; i < set->count; i++)
        document_close(&set->documents[i]);
}

static const char *const lambert[] = {"tests/layouts/lambert.yaml"},
                         *const grays[] = {"tests/layouts/grays.yaml"},
                         *const glow[] = {"tests/layouts/glow.yaml"},
                         *const mixed[] = {"tests/layouts/mixed.yaml"};
#endif
