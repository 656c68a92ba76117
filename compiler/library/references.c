/* The references of the functions in grammar/functions.def and of the volume maps in maps.def. */
#include "compiler/library/references.h"
#include "grammar/tables.h"
#include <stddef.h>

#define FUNCTION(name, result, arguments, range, cost, doc)                                        \
    void reference_##name(const void *, const double *, double *);
#include "grammar/functions.def"

#define OWN_DECLARATION(function)
#define VOLUME_DECLARATION(function)                                                               \
    void reference_##function(const void *, const double *, double *);
#define MAP(name, function, lowering, cost, doc) lowering##_DECLARATION(function)
#include "grammar/maps.def"

Reference reference_of(int function)
{
#define OWN_REFERENCE(name, function)
#define VOLUME_REFERENCE(name, function) [FN_FIRST_MAP + KIND_##name] = reference_##function,
    static const Reference references[FUNCTION_COUNT] = {
#define FUNCTION(name, result, arguments, range, cost, doc) reference_##name,
#include "grammar/functions.def"
#define MAP(name, function, lowering, cost, doc) lowering##_REFERENCE(name, function)
#include "grammar/maps.def"
    };
    return references[function];
}
