/* State that the parts of `matbench error` share: drawing, and where results go. */
#ifndef MATBENCH_ERROR_H
#define MATBENCH_ERROR_H
#include "runtime/autotune/autotune.h"
#include "runtime/autotune/plot.h"
#include <stdio.h>

enum { TARGETS_LIMIT = 64, TARGET_TEXT = 256, PANELS_LIMIT = 32 };

/* A row of the table of targets. */
typedef struct {
    char what[TARGET_TEXT], wanted[TARGET_TEXT], measured[TARGET_TEXT];
    bool reached;
} ErrorTarget;

/* Parts of the page, a table each; the template names them as @NORMALS@ and so on. */
typedef enum {
    SECTION_PART_materials,
    SECTION_PART_normals,
    SECTION_PART_checker,
    SECTION_PART_noise,
    SECTION_PART_powers,
    SECTION_PART_codes,
    SECTION_PART_layouts,
    SECTION_PART_count
} SectionPart;

typedef struct {
    Meter *meter;
    char command[1024]; /* command line */
    bool quick;
    double seconds; /* time for each material */
    /* on a GPU, timed pictures are wider and higher by this factor, because draws are too short
     * otherwise */
    int factor;
    FILE *csv;                      /* group,subject,gl,variant,quantity,value */
    FILE *part[SECTION_PART_count]; /* Markdown */
    ErrorTarget targets[TARGETS_LIMIT];
    int target_count;
    PlotPanel panels[PANELS_LIMIT];
    int panel_count;
} ErrorBench;

__attribute__((format(printf, 4, 5))) void error_target(ErrorBench *bench, const char *what,
                                                        bool reached,
                                                        const char *wanted_then_measured, ...);
/* Row key of the CSV. */
typedef struct {
    const char *group, *name, *variant;
} ErrorSubject;

void error_figure(ErrorBench *bench, ErrorSubject of, const char *quantity, double value);

/* Reads a built-in document with its pictures; an error in it ends the program. */
MatcDocument *error_document(const char *name, const char *text);
/* A program of pass value, slot diffuse, for a document's first material. NULL: a compile error. */
MatcProgram *error_program(const MatcDocument *document, const Variant *variant);
/* Makes a drawable material. Returns false on a compile error. */
bool error_material(ErrorBench *bench, const MatcDocument *document, const Variant *variant,
                    Material *made);

/* Each function fills its parts and targets. */
void error_normals(ErrorBench *bench);
void error_materials(ErrorBench *bench);
void error_checker(ErrorBench *bench);
void error_noise(ErrorBench *bench);
void error_powers(ErrorBench *bench);
void error_codes(ErrorBench *bench);
void error_layouts(ErrorBench *bench);

/* Builds the page from its template, the parts and the targets. From malloc; NULL: the template
 * cannot be read. */
char *error_page(ErrorBench *bench, const char *plot, char *const *parts);
#endif
