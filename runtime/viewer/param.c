/* The compiler parses a value as a param's default in a minimal document. All document syntax is
 * therefore accepted, and errors are the compiler's diagnostics. */
#include "runtime/viewer/param.h"
#include <stdio.h>
#include <string.h>

/* Reads the uniform that the compiler generated for "{ param: name, default: VALUE }". */
static bool take_uniform(const MatcDocument *document, const MatcOptions *options, Param *param,
                         int colors)
{
    MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, options);
    const MatcUniform *uniform =
        matc_ok(program) && matc_uniform_count(program) == 1 ? matc_uniform(program, 0) : NULL;
    bool found = uniform && !strcmp(uniform->param, param->name);
    if (found) {
        param->components = uniform->components;
        for (int component = 0; component < uniform->components; component++)
            param->values[colors][component] = (float)uniform->initial[component];
    }
    matc_program_free(program);
    return found;
}

static const char *read_value(const char *value, Param *param, int colors,
                              char reason[PARAM_CAPACITY])
{
    static const char *const names[] = {"linear", "srgb"};
    MatcOptions options;
    matc_options_init(&options);
    options.validate = false;
    options.pass = "value";
    options.slot = "emissive";
    const char *quote = *value == '#' ? "\"" : ""; /* unquoted, # starts a comment */
    int size = snprintf(reason, PARAM_CAPACITY,
                        "colors: %s\nmaterial: Phong\nemissive:\n  param: %s\n  default: %s%s%s\n",
                        names[colors], param->name, quote, value, quote);
    if (size >= PARAM_CAPACITY)
        return "--param: the value is too long";
    MatcDocument *document = matc_read("--param", reason, (size_t)size, &options);
    bool fine =
        matc_material_count(document) == 1 && take_uniform(document, &options, param, colors);
    if (!fine)
        snprintf(reason, PARAM_CAPACITY, "--param: '%s' is no value of a param:\n%s", value,
                 matc_diagnostics(document, MATC_TEXT));
    matc_document_free(document);
    return fine ? NULL : reason;
}

const char *param_read(const char *text, Param *param, char reason[PARAM_CAPACITY])
{
    const char *equal = strchr(text, '=');
    size_t size = equal ? (size_t)(equal - text) : 0;
    if (!size || !equal[1])
        return "--param expects name=value";
    if (size >= PARAM_NAME)
        return "--param: the name is too long";
    *param = (Param){0};
    memcpy(param->name, text, size);
    const char *fault = read_value(equal + 1, param, 0, reason);
    return fault ? fault : read_value(equal + 1, param, 1, reason);
}

/* Looks for the key in the normalized document text, which has one line per key however the
 * document was written. */
int param_colors(MatcDocument *document)
{
    static const char key[] = "\ncolors: srgb\n";
    const char *tree = matc_tree_text(document);
    return tree && (!strncmp(tree, key + 1, strlen(key + 1)) || strstr(tree, key));
}

bool param_fit(Param *param, int components)
{
    for (int colors = 0; colors < 2; colors++) {
        float *values = param->values[colors];
        if (param->components == 3 && components == 4)
            values[3] = 1;
        else if (param->components == 1)
            for (int component = 1; component < components; component++)
                values[component] = values[0];
        else if (param->components != components)
            return false;
    }
    param->components = components;
    return true;
}
