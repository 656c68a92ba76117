/* Reads the interfaces of a SPIR-V module from its words, by the specification alone. */
#ifndef MATC_VALUE_SPIRV_H
#define MATC_VALUE_SPIRV_H
#include <stdbool.h>
#include <stddef.h>

enum { SPIRV_VARIABLES = 64, SPIRV_TYPE = 600 };
typedef enum { SPIRV_texture = 0, SPIRV_input = 1, SPIRV_block = 2, SPIRV_output = 3 } SpirvStorage;
typedef struct {
    SpirvStorage storage;
    int location, set, binding; /* -1: it has none */
    bool array;                 /* of what it has one for each vertex, `type` leaves that out */
    /* "f32x3", "{0:f32x4x4 64:f32x3x3}": members of blocks by their offsets */
    char type[SPIRV_TYPE];
} SpirvVariable;
typedef struct {
    /* of its one entry point: 0 vertices, 1 control, 2 evaluation, 3 geometry, 4 fragments, 5
     * compute; -1: it has none or several */
    int model;
    int local_size;
    int count;
    SpirvVariable variables[SPIRV_VARIABLES]; /* those that have a location or a binding */
} SpirvModule;

/* False: these are no such words. */
bool spirv_read(const char *words, size_t size, SpirvModule *module);
#endif
