/* The parts of main.c; only these files print. Each function returns the program's exit status. */
#ifndef MATC_MAIN_H
#define MATC_MAIN_H
#include "compiler/base/diag.h"
#include "compiler/tool/options.h"

enum {
    EXIT_OK = 0,
    EXIT_ERROR = 1,
    USAGE = 2,
    BY_SIGNAL = 128 /* exit status of a run ended by a signal, plus the signal's number */
};

/* Prints a message to stderr, as text or JSON. `what`: a file or an option; may be NULL. */
void main_complaint(const CommandLine *line, Severity severity, const char *what, const char *why);
int main_complain(const CommandLine *line, const char *what, const char *why);
/* Prints diagnostics, or a one-line fault. */
void main_fault(const CommandLine *line, const char *fault);
int main_usage(const CommandLine *line, const char *what);

/* Compiles, evaluates or measures a document's only or selected material, and writes the result. */
int main_document(const CommandLine *line, const char *path);
/* Lists a document's definitions, for --list and --explain. main_is_document() tests whether a
 * name is a document's. */
int main_definitions(CommandLine *line, const char *path);
bool main_is_document(const char *name);
/* Sets the options for a material; with --max-error, those that measuring selects. */
int main_choose(const CommandLine *line, const MatcDocument *document, int material,
                MatcOptions *options);
#endif
