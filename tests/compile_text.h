/* Compiles a test's documents through the library: without glslang, with every check of the IR. */
#ifndef TESTS_COMPILE_TEXT_H
#define TESTS_COMPILE_TEXT_H
#include "compiler/matc.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static inline MatcOptions quick(void)
{
    MatcOptions options;
    matc_options_init(&options);
    options.validate = false;
    options.check = true;
    return options;
}

static inline MatcDocument *read_text(const char *text, const MatcOptions *options)
{
    return matc_read("test.yaml", text, strlen(text), options);
}

static inline char *compile_text(const char *text, unsigned output, const MatcOptions *options)
{
    MatcDocument *document = read_text(text, options);
    MatcProgram *program = matc_compile(document, 0, output, options);
    if (!matc_ok(program))
        fprintf(stderr, "%s%s", matc_diagnostics(document, MATC_TEXT),
                matc_program_diagnostics(program, MATC_TEXT));
    assert_true(matc_ok(program));
    char *result = strdup(matc_output(program, (MatcOutput)output, NULL));
    matc_program_free(program);
    matc_document_free(document);
    return result;
}

static const char *const checker_text =
    "material: Phong\n"
    "diffuse: { map: Checker, color1: 0.3, color2: { map: Granite } }\n"
    "specular: { map: Granite }\n";
#endif
