/* Parameters of definitions: what is declared of one, and which arguments it takes. */
#ifndef MATC_RESOLVE_PARAMETER_H
#define MATC_RESOLVE_PARAMETER_H
#include "compiler/resolve/resolve.h"

/* Type of an argument, by the word of `type:`; without it, by the default. */
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
    const Member *member; /* of `params:` */
    ParameterType type;
    Tree *init;             /* NULL: a use must say it */
    const Tree *low, *high; /* numbers, or NULL */
} Parameter;

/* The word of a type. */
const char *resolve_parameter_type(ParameterType type);
/* name: default, or name: { default, type, doc, min, max }. False: told. */
bool resolve_parameter(Resolver *r, const Member *member, Parameter *parameter);
/* Whether the parameter of that definition takes the argument. False: told. */
bool resolve_argument(Resolver *r, const Member *definition, const Parameter *parameter,
                      const Tree *argument);
/* A note at the parameter, of what an argument for it does wrong. */
void resolve_say_parameter(Resolver *r, const Member *definition, const Parameter *parameter);
#endif
