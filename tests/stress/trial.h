/* Tries one document in every mode: the oracle, the IR as written, and the optimized IR, in
 * double, in float and as drawn, agree; every number is finite; the program is valid. */
#ifndef MATC_STRESS_TRIAL_H
#define MATC_STRESS_TRIAL_H
#include "field.h"
#include "pixel.h"
#include "tests/value/documents.h"
#include "tests/draw/draw.h"

typedef enum {
    FAULT_none,
    FAULT_refused,    /* the document has errors: a fault of the generator */
    FAULT_no_ir,      /* lowering or the optimizer failed */
    FAULT_text,       /* the IR's text does not read back as itself */
    FAULT_infinite,   /* a value in double that is not finite */
    FAULT_level_0,    /* the IR as written differs from the oracle */
    FAULT_level_2,    /* the optimized IR differs */
    FAULT_float,      /* a value in float that is not finite */
    FAULT_packed,     /* a packed number out of its range */
    FAULT_not_valid,  /* glslang refuses the program */
    FAULT_not_drawn,  /* the driver refuses the program */
    FAULT_drawn_nan,  /* a drawn value is NaN */
    FAULT_drawn_value /* a drawn value too far from the oracle */
} FaultKind;
extern const char *const fault_names[];

typedef struct {
    FaultKind kind;
    char text[1024];
} TrialFault;

/* Limit of an expression's values, above which a float's square could overflow: greater values
 * are no fault. */
#define GREATEST_VALUE 1e18

typedef struct {
    MatcOptions options; /* compile options, such as aa; other options are set here */
    const Point *field;  /* FIELD_COUNT points */
    int first, count;    /* range of points that are evaluated */
    Pixel pixel;         /* pixel for filtered programs */
    bool oracle;         /* the oracle supports the options */
    bool validate;       /* validate by glslang, for all targets */
    /* GREATEST_VALUE; INFINITY: no intermediate value of a slot is an excuse */
    double greatest;
    bool only_finite; /* drawn values only have to be finite */
    /* drawers with the field's points; NULL: do not draw */
    Drawer *core, *compat;
    Drawer *core_half, *compat_half; /* with RGBA16F targets, for the G-buffer */
} TrialPlan;

/* Counts of the work done, for statistics. */
typedef struct {
    long trees, nodes, values, spreads, validated, programs, drawn_values, judged, beyond;
    long slopes; /* slots at points with known exact derivatives */
} TrialCount;

/* State of a trial, shared by its parts. */
typedef struct {
    const TrialPlan *plan;
    Arena arena;
    MatcOptions options;
    Session session;
    Tree *tree;
    Graph *graph;
    const Node *material;
    Oracle *oracle;
    bool exact; /* derivatives are exact, and the oracle's are finite differences */
    TrialFault *fault;
    TrialCount *count;
    bool slots[SLOT_COUNT]; /* slots to compare */
    bool bumps[SLOT_COUNT]; /* slots to which a BumpMap contributes */
} Trial;

/* Returns false with a fault. */
bool trial_run(const TrialPlan *plan, const char *text, size_t size, TrialCount *count,
               TrialFault *fault);

/* Parts of a trial. trial_fault returns false. */
__attribute__((format(printf, 3, 4))) bool trial_fault(Trial *t, FaultKind kind, const char *format,
                                                       ...);
/* IR of a slot or pass, in the given arena; NULL with a fault. */
const Ir *trial_ir(Trial *t, Arena *arena, Pass pass, Slot slot, int level);
/* The oracle's value of a slot, and the error of its finite differences against a true slope;
 * trial_oracle.c */
typedef struct {
    SlotValues value, tolerance;
    bool known;
} TrialWanted;
void trial_query_oracle(Trial *t, const Point *point, bool front, Slot slot, TrialWanted *w);
/* trial_draw.c */
bool trial_draw(Trial *t, const char *text, size_t size);
bool trial_validate(Trial *t, const char *text, size_t size);
#endif
