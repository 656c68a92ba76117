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
    FAULT_refused,    /* the document has errors: the generator's fault */
    FAULT_no_ir,      /* lowering or the optimiser failed */
    FAULT_text,       /* the IR's text does not read back as itself */
    FAULT_infinite,   /* a number in double that is none */
    FAULT_level_0,    /* the IR as written differs from the oracle */
    FAULT_level_2,    /* the optimised IR differs */
    FAULT_float,      /* a number in float that is none */
    FAULT_packed,     /* a packed number out of its range */
    FAULT_not_valid,  /* glslang refuses it */
    FAULT_not_drawn,  /* the driver refuses it */
    FAULT_drawn_nan,  /* a drawn number that is none */
    FAULT_drawn_value /* a drawn number too far from the oracle */
} FaultKind;
extern const char *const fault_names[];

typedef struct {
    FaultKind kind;
    char text[1024];
} TrialFault;

/* No value of an expression may be greater, or a float's square would be infinite: what lies beyond
 * is no fault. */
#define GREATEST_VALUE 1e18

typedef struct {
    MatcOptions options; /* choices, such as aa; what else there is in it is set here */
    const Point *field;  /* FIELD_COUNT points */
    int first, count;    /* of the points that are evaluated */
    Pixel pixel;         /* of a program that is averaged over it */
    bool oracle;         /* it knows the choices */
    bool validate;       /* by glslang, for all targets */
    /* GREATEST_VALUE, or INFINITY: of a slot no value on the way is an excuse */
    double greatest;
    bool only_finite; /* of what is drawn no more is asked */
    /* with the field in them: the program is drawn; NULL: it is not */
    Drawer *core, *compat;
    Drawer *core_half, *compat_half; /* of RGBA16F targets, for the G-buffer */
} TrialPlan;

/* Counts of the work done, for statistics. */
typedef struct {
    long trees, nodes, values, spreads, validated, programs, drawn_values, judged, beyond;
    long slopes; /* slots at points where exact derivatives are known */
} TrialCount;

/* The document, as the parts of a trial share it. */
typedef struct {
    const TrialPlan *plan;
    Arena arena;
    MatcOptions options;
    Session session;
    Tree *tree;
    Graph *graph;
    const Node *material;
    Oracle *oracle;
    bool exact; /* derivatives: of what is computed, which the oracle takes differences of */
    TrialFault *fault;
    TrialCount *count;
    bool slots[SLOT_COUNT]; /* those that are looked at */
    bool bumps[SLOT_COUNT]; /* those that a BumpMap takes part in */
} Trial;

/* False: see the fault. */
bool trial_run(const TrialPlan *plan, const char *text, size_t size, TrialCount *count,
               TrialFault *fault);

/* Parts of it. trial_fault returns false. */
__attribute__((format(printf, 3, 4))) bool trial_fault(Trial *t, FaultKind kind, const char *format,
                                                       ...);
/* One slot's or one pass' IR, in an arena of its own; NULL and a fault. */
const Ir *trial_ir(Trial *t, Arena *arena, Pass pass, Slot slot, int level);
/* The oracle's value of a slot, and how far a true slope may be from its differences;
 * trial_oracle.c */
typedef struct {
    SlotValues value, capacity;
    bool known;
} TrialWanted;
void trial_query_oracle(Trial *t, const Point *point, bool front, Slot slot, TrialWanted *w);
/* trial_draw.c */
bool trial_draw(Trial *t, const char *text, size_t size);
bool trial_validate(Trial *t, const char *text, size_t size);
#endif
