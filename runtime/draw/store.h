/* Objects that materials share on the GPU: programs with one text, pictures with the same texels;
 * each is made once and freed with its last user. */
#ifndef MATC_DRAW_STORE_H
#define MATC_DRAW_STORE_H
#include "runtime/gl/program.h"
#include "runtime/gl/texture.h"
#include "runtime/gl/uniforms.h"

/* Value of a plain uniform as the driver holds it. */
typedef struct StoreHeld {
    bool known;
    float values[16];
} StoreHeld;

/* The store of one context, which is current at every call. */
typedef struct Store Store;

/* A program or a texture. */
typedef struct {
    GLuint name;
    GlUniforms uniforms;    /* of a program */
    struct StoreHeld *held; /* of a program, by uniform: what it was handed last */
} StoreItem;

/* NULL: see gl->error. */
Store *store_new(GlContext *gl);
/* With all that is left in it; before its context is closed. NULL is nothing. */
void store_free(Store *store);
GlContext *store_context(const Store *store);

/* Compiles and links, or gives what there is of these texts. NULL: see gl->error. */
const StoreItem *store_program(Store *store, const ProgramText *text);
/* Makes a texture, or gives the one there is of these texels and this filter. NULL: see
 * gl->error. */
const StoreItem *store_texture(Store *store, const TextureSpec *spec);
/* One user less. NULL is nothing. */
void store_drop(Store *store, const StoreItem *item);

/* How many there are now. */
int store_program_count(const Store *store);
int store_texture_count(const Store *store);
#endif
