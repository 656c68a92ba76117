/* A MatcProgram as GL draws with it: its program, its pictures and tables of noise, its uniforms,
 * its numbers. The bridge between compiler and driver, for the viewer, the measuring, the tests and
 * the benchmarks. Of a store, whose context is current. */
#ifndef MATC_DRAW_MATERIAL_H
#define MATC_DRAW_MATERIAL_H
#include "compiler/base/hash.h"
#include "compiler/matc.h"
#include "runtime/draw/store.h"

enum { MATERIAL_TEXTURES = 32 };

/* Value of a uniform. Its type in the program decides how the numbers are read (uniforms.h). */
typedef struct {
    const char *name;
    int lanes; /* 1-4; 9 and 16 for a matrix, by columns */
    const float *values;
} MaterialValue;

typedef struct {
    Store *store;
    const StoreItem *program;                     /* shared */
    const StoreItem *textures[MATERIAL_TEXTURES]; /* shared; texture i is on unit i */
    int texture_count;
    /* its own, as is what follows: of program->uniforms that are plain, 0 before they are set */
    float (*values)[16];
    struct MaterialBlock *blocks;
    struct MeshFeed *feeds; /* attributes of meshes that it reads by name */
    int feed_count;
} Material;

/* Makes it of a program, with the defaults of its uniforms, ior 1 and an eye that looks as the
 * world does. `text` is the GLSL, or what replaces the program's own: a shader that it leaves out
 * is taken from the program. Without a program (NULL) `text` is all. The program is not kept.
 * False: see the context's error; *made is empty. */
bool material_make(Store *store, MatcProgram *program, const ProgramText *text, Material *made);
/* Safe on an empty one, which it leaves behind. */
void material_delete(Material *material);

/* Sets a uniform, plain or member of a block, for this material alone. False if the program has
 * none of that name and those lanes, which is no error: a driver drops what a program does not
 * use. */
bool material_set(Material *material, const MaterialValue *value);
bool material_set_number(Material *material, const char *name, float number);
/* It has a uniform of that name. */
bool material_has(const Material *material, const char *name);
/* Adds a texture for a sampler. A program that has no such sampler goes without; false: see the
 * context's error. */
bool material_set_texture(Material *material, const char *sampler, const TextureSpec *spec);

/* The numbers that another program of the same key has, for its own: the buffer stays, its bytes
 * change. */
bool material_set_numbers(Material *material, const MatcProgram *program);
/* Bytes of a block, in std140, from its start. False if the program has no such block. */
bool material_write(Material *material, const char *block, const void *bytes, size_t size);

/* Makes its program the current one, binds its textures and buffers, and hands over what it does
 * not hold already. The block View is whoever draws' own (uniforms.h). */
void material_use(Material *material);
/* Uses a material directly after `before`: bindings that both have are not bound again. */
void material_use_after(Material *material, const Material *before);
/* Hash of a material: its program, textures, uniforms and numbers, as they are now. */
Key material_key(const Material *material);
#endif
