/* The parts of main.c, which alone print. Each returns the program's exit status. */
#ifndef MATC_MAIN_H
#define MATC_MAIN_H
#include "compiler/base/diag.h"
#include "compiler/tool/options.h"

enum {
    FINE = 0,
    FAULT = 1,
    USAGE = 2,
    BY_SIGNAL = 128 /* and its number */
};

/* On stderr, as text or as JSON. `what`: a file or an option; NULL: neither. */
void main_complaint(const CommandLine *line, Severity severity, const char *what, const char *why);
int main_complain(const CommandLine *line, const char *what, const char *why);
/* Diagnostics, or what is wrong in a line. */
void main_fault(const CommandLine *line, const char *fault);
int main_usage(const CommandLine *line, const char *what);

/* A document and its one material: compiled, evaluated or measured, and written. */
int main_document(const CommandLine *line, const char *path);
/* Lists a document's definitions, for --list and --explain. Whether a name is that of a document.
 * */
int main_definitions(CommandLine *line, const char *path);
bool main_is_document(const char *name);
/* The options that a material is compiled with: with --max-error, those that measuring finds. */
int main_choose(const CommandLine *line, const MatcDocument *document, int material,
                MatcOptions *options);
#endif
