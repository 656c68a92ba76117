/* Reads the interfaces of a SPIR-V module from its words, by the specification alone. */
#ifndef MATC_VALUE_SPIRV_H
#define MATC_VALUE_SPIRV_H
#include <stdbool.h>
#include <stddef.h>

enum { SPIRV_VARIABLES = 64, SPIRV_TYPE = 600 };
typedef enum { SPIRV_texture = 0, SPIRV_input = 1, SPIRV_block = 2, SPIRV_output = 3 } SpirvStorage;
typedef struct {
    SpirvStorage storage;
    int location, set, binding; /* -1: none */
    bool array;                 /* one value per vertex; `type` is the element's type */
    /* "f32x3", "{0:f32x4x4 64:f32x3x3}": members of blocks by their offsets */
    char type[SPIRV_TYPE];
} SpirvVariable;
typedef struct {
    /* stage of its single entry point: 0 vertex, 1 control, 2 evaluation, 3 geometry, 4
     * fragment, 5 compute; -1: none or several entry points */
    int model;
    int local_size;
    int count;
    SpirvVariable variables[SPIRV_VARIABLES]; /* variables with a location or a binding */
} SpirvModule;

/* Returns false if the words are no valid module. */
bool spirv_read(const char *words, size_t size, SpirvModule *module);
#endif
