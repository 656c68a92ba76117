/* Prints diagnostics as text or JSON. */
#include "compiler/tool/main.h"
#include "compiler/base/text.h"
#include <stdio.h>
#include <string.h>

void main_complaint(const CommandLine *line, Severity severity, const char *what, const char *why)
{
    Arena arena = {0};
    Text text = text_new(&arena);
    diag_complain(&text, line->diagnostics, severity, what, why);
    fputs(text.at, stderr);
    arena_free(&arena);
}

int main_complain(const CommandLine *line, const char *what, const char *why)
{
    main_complaint(line, SEVERITY_error, what, why);
    return EXIT_ERROR;
}

void main_fault(const CommandLine *line, const char *fault)
{
    if (strchr(fault, '\n'))
        fputs(fault, stderr);
    else
        main_complain(line, NULL, fault);
}

int main_usage(const CommandLine *line, const char *what)
{
    if (line->diagnostics == MATC_JSON)
        main_complain(line, NULL, what);
    else
        fprintf(stderr, "matc: %s; see matc --help\n", what);
    return USAGE;
}
