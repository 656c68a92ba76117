/* Compiles every variant; equal programs are kept once. */
#include "runtime/measure/candidates.h"
#include <stdlib.h>
#include <string.h>

/* What is measured is GLSL 3.30; what is wanted may be another target, which can lack a layout. */
static bool is_wanted(const MeasureRequest *request, const MatcOptions *options)
{
    if (!options->target || !strcmp(options->target, "glsl330"))
        return true;
    MatcOptions quiet = *options;
    quiet.validate = quiet.measure = false;
    MatcProgram *program = matc_compile(request->document, request->material, MATC_FRAGMENT, &quiet);
    bool ok = matc_ok(program);
    matc_program_free(program);
    return ok;
}

Candidate *candidates_make(const MeasureRequest *request, MeasuredList *list, int *count)
{
    int all;
    Variant base;
    variant_of(request->options, &base);
    Variant *variants = variant_list(&base, &request->open, &all);
    Candidate *kept = calloc((size_t)all + 1, sizeof *kept);
    if (!kept)
        abort();
    *count = 0;
    for (int i = 0; i < all; i++) {
        MatcOptions options = variant_options(&variants[i], request->options);
        options.pass = "gbuffer";
        MatcProgram *program = is_wanted(request, &options) ? variant_compile(request->document, request->material,
                                                                             MATC_FRAGMENT | MATC_UNPACK, &options)
                                                            : NULL;
        bool same = false;
        for (int k = 0; k < *count && program && !same; k++)
            same = variant_programs_equal(matc_output(kept[k].program, MATC_FRAGMENT, NULL),
                                          matc_output(program, MATC_FRAGMENT, NULL));
        list->same += same;
        list->refused += !program;
        if (same || !program) {
            matc_program_free(program);
            continue;
        }
        kept[(*count)++] = (Candidate){variants[i], program};
    }
    free(variants);
    return kept;
}
