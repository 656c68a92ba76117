/* Objects that materials share on the GPU: programs of equal text, and textures of equal texels;
 * each is made once and freed with its last user. */
#ifndef MATC_GPU_MATERIAL_STORE_H
#define MATC_GPU_MATERIAL_STORE_H
#include "runtime/gl/program.h"
#include "runtime/gl/texture.h"
#include "runtime/gl/uniforms.h"

/* Value of a plain uniform as last passed to the driver. */
typedef struct StoreHeld {
    bool known;
    float values[16];
} StoreHeld;

/* The store of one context, which must be current at every call. */
typedef struct Store Store;

/* A program or a texture. */
typedef struct {
    GLuint name;
    GlUniforms uniforms;    /* set for programs only */
    struct StoreHeld *held; /* programs only: last uploaded value of each uniform */
} StoreItem;

/* Makes an empty store. NULL on failure; see gl->error. */
Store *store_new(GlContext *gl);
/* Frees the store with all its objects, before the context is closed. Does nothing for NULL. */
void store_free(Store *store);
GlContext *store_context(const Store *store);

/* Compiles and links a program, or returns the existing one of the same texts. NULL on failure;
 * see gl->error. */
const StoreItem *store_program(Store *store, const ProgramText *text);
/* Makes a texture, or returns the existing one of the same texels and filter. NULL on failure;
 * see gl->error. */
const StoreItem *store_texture(Store *store, const TextureSpec *spec);
/* Releases a reference to an object. Does nothing for NULL. */
void store_drop(Store *store, const StoreItem *item);

/* Return the numbers of objects in the store. */
int store_program_count(const Store *store);
int store_texture_count(const Store *store);
#endif
