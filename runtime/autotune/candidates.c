/* Compiles every variant and removes duplicate programs. */
#include "runtime/autotune/candidates.h"
#include <stdlib.h>
#include <string.h>

/* Returns whether the variant compiles for the requested target, which can lack a layout. The
 * measurement itself uses GLSL 3.30. */
static bool is_wanted(const AutotuneRequest *request, const MatcOptions *options)
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

/* Returns NULL if the variant does not compile, or does not for the requested target. */
static MatcProgram *compile_variant(const AutotuneRequest *request, const Variant *variant)
{
    MatcOptions options = variant_options(variant, request->options);
    options.pass = "gbuffer";
    if (!is_wanted(request, &options))
        return NULL;
    return variant_compile(request->document, request->material, MATC_FRAGMENT | MATC_UNPACK,
                           &options);
}

/* Returns whether a kept candidate has an equal program. */
static bool is_among(const Candidate *kept, int count, const MatcProgram *program)
{
    const char *text = matc_output(program, MATC_FRAGMENT, NULL);
    for (int k = 0; k < count; k++)
        if (variant_programs_equal(matc_output(kept[k].program, MATC_FRAGMENT, NULL), text))
            return true;
    return false;
}

Candidate *candidates_make(const AutotuneRequest *request, MeasuredList *list, int *count)
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
