/* GLSL around the programs of opaque surfaces, which then also write a word about the visible
 * triangle to the target `seen`. */
#ifndef MATC_GPU_SCENE_TRIANGLE_ID_TEXT_H
#define MATC_GPU_SCENE_TRIANGLE_ID_TEXT_H
#include "runtime/gpu_scene/material_set.h"
#include "runtime/gpu_material/store.h"

enum { SEEN_TEXT_DEFINED = 96 };

/* GLSL that writes the word. */
typedef struct {
    /* text that writes to location SEEN_TARGET; its main() calls surfaceMain() */
    const char *fragment;
    /* reads seen_place, the index of the object's place: an input if SEEN_INSTANCES is defined,
     * else a uniform */
    bool places;
} TriangleIdText;

/* Texts for the programs of a set; `text` is NULL if programs write no such word. */
typedef struct {
    const TriangleIdText *text;
    const char *head;
    char defined[SEEN_TEXT_DEFINED];
    bool instances;
} TriangleIdTextParts;

void triangle_id_text_make(const GlContext *gl, const MaterialSet *set, const TriangleIdText *text,
                           TriangleIdTextParts *made);
/* Wraps a material's programs, each a single text; *around must live until they are compiled. */
void triangle_id_text_wrap(const TriangleIdTextParts *around, ProgramText *program);
#endif
