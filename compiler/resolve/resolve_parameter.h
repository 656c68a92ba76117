/* Parameters of definitions: their declarations, and the arguments that they accept. */
#ifndef MATC_RESOLVE_PARAMETER_H
#define MATC_RESOLVE_PARAMETER_H
#include "compiler/resolve/resolve.h"

/* Type of an argument: given by `type:`, otherwise inferred from the default. */
typedef enum {
    PARAMETER_number,
    PARAMETER_color,
    PARAMETER_map,
    PARAMETER_material,
    PARAMETER_wave,
    PARAMETER_transform,
    PARAMETER_bool,
    PARAMETER_text,
    PARAMETER_TYPES
} ParameterType;

typedef struct {
    const Member *member; /* member of `params:` that declares the parameter */
    ParameterType type;
    Tree *init;             /* default value; NULL: every use must give an argument */
    const Tree *low, *high; /* numbers of the keys `min` and `max`; NULL: missing */
} Parameter;

/* Returns the name of a type. */
const char *resolve_parameter_type(ParameterType type);
/* Parses name: default, or name: { default, type, doc, min, max }. Returns false after reporting
 * a fault. */
bool resolve_parameter(Resolver *r, const Member *member, Parameter *parameter);
/* Returns true if the parameter of a definition accepts an argument. Returns false after
 * reporting a fault. */
bool resolve_argument(Resolver *r, const Member *definition, const Parameter *parameter,
                      const Tree *argument);
/* Adds a note at the parameter that rejected an argument. */
void resolve_report_parameter(Resolver *r, const Member *definition, const Parameter *parameter);
#endif
