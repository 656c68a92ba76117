/* Compiles every variant; equal programs are kept once. */
#include "runtime/measure/candidates.h"
#include <stdlib.h>
#include <string.h>

/* Measurements use GLSL 3.30; the requested target may be another one, which can lack a layout. */
static bool is_wanted(const MeasureRequest *request, const MatcOptions *options)
{
    if (!options->target || !strcmp(options->target, "glsl330"))
        return true;
    MatcOptions quiet = *options;
    quiet.validate = quiet.measure = false;
    MatcProgram *program =
        matc_compile(request->document, request->material, MATC_FRAGMENT, &quiet);
    bool ok = matc_ok(program);
    matc_program_free(program);
    return ok;
}

/* NULL: it is not asked for, or does not compile. */
static MatcProgram *compile_variant(const MeasureRequest *request, const Variant *variant)
{
    MatcOptions options = variant_options(variant, request->options);
    options.pass = "gbuffer";
    if (!is_wanted(request, &options))
        return NULL;
    return variant_compile(request->document, request->material, MATC_FRAGMENT | MATC_UNPACK,
                           &options);
}

/* Whether one of them has the same text. */
static bool is_among(const Candidate *kept, int count, const MatcProgram *program)
{
    const char *text = matc_output(program, MATC_FRAGMENT, NULL);
    for (int k = 0; k < count; k++)
        if (variant_programs_equal(matc_output(kept[k].program, MATC_FRAGMENT, NULL), text))
            return true;
    return false;
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
        MatcProgram *program = compile_variant(request, &variants[i]);
        const bool same = program && is_among(kept, *count, program);
        list->same += same;
        list->refused += !program;
        if (program && !same)
            kept[(*count)++] = (Candidate){variants[i], program};
        else
            matc_program_free(program);
    }
    free(variants);
    return kept;
}
