/* A MatcProgram with its GL resources: program, textures and noise tables, uniforms, constants.
 * It connects the compiler to the driver, for the viewer, autotuning, tests and benchmarks. It
 * belongs to a store, whose context must be current. */
#ifndef MATC_GPU_MATERIAL_MATERIAL_H
#define MATC_GPU_MATERIAL_MATERIAL_H
#include "compiler/base/hash.h"
#include "compiler/matc.h"
#include "runtime/gpu_material/store.h"

enum { MATERIAL_TEXTURES = 32 };

/* Value of a uniform, converted to the uniform's type (uniforms.h). */
typedef struct {
    const char *name;
    int components; /* number of components: 1 to 4; 9 and 16 for a matrix, by columns */
    const float *values;
} MaterialValue;

typedef struct {
    Store *store;
    const StoreItem *program;                     /* program, shared with other materials */
    const StoreItem *textures[MATERIAL_TEXTURES]; /* shared textures; texture i is on unit i */
    int texture_count;
    /* Values of this material for the plain uniforms in program->uniforms, initially 0. */
    float (*values)[16];
    struct MaterialBlock *blocks;
    struct MeshFeed *feeds; /* attributes of meshes that the program reads by name */
    int feed_count;
} Material;

/* Makes a material of a compiled program, with the defaults of its uniforms, ior 1 and an eye
 * aligned with the world's axes. `text` has GLSL that replaces the program's; omitted stages are
 * taken from the program. With program NULL `text` is complete. The program is not kept. Returns
 * false on failure, with *made empty; see the context's error. */
bool material_make(Store *store, MatcProgram *program, const ProgramText *text, Material *made);
/* Frees the material and leaves it empty; safe on an empty one. */
void material_delete(Material *material);

/* Sets a uniform, plain or member of a block, for this material alone. Returns false if the
 * program has none with the given name and number of components; that is no error, since a driver
 * removes unused uniforms. */
bool material_set(Material *material, const MaterialValue *value);
bool material_set_number(Material *material, const char *name, float number);
/* Reports whether the program has a uniform with the given name. */
bool material_has(const Material *material, const char *name);
/* Adds a texture for a sampler; does nothing if the program has no such sampler. Returns false
 * on failure; see the context's error. */
bool material_set_texture(Material *material, const char *sampler, const TextureSpec *spec);

/* Sets the constants to those of another program of the same key. The buffer is kept, its bytes
 * change. */
bool material_set_numbers(Material *material, const MatcProgram *program);
/* Writes the bytes of a uniform block, in std140, from its start. Returns false if the program
 * has no such block. */
bool material_write(Material *material, const char *block, const void *bytes, size_t size);

/* Makes the program current, binds its textures and buffers, and passes values that have
 * changed. The caller binds the block View (uniforms.h). */
void material_use(Material *material);
/* Uses a material directly after `before`: bindings that both share are kept. */
void material_use_after(Material *material, const Material *before);
/* Returns the hash of a material's current program, textures, uniforms and constants. */
Key material_key(const Material *material);
#endif
