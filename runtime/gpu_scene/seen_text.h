/* GLSL around the programs of opaque surfaces, which then also write a word about the visible
 * triangle to the target `seen`. */
#ifndef MATC_GPU_SCENE_SEEN_TEXT_H
#define MATC_GPU_SCENE_SEEN_TEXT_H
#include "runtime/gpu_scene/material_set.h"
#include "runtime/gpu_material/store.h"

enum { SEEN_TEXT_DEFINED = 96 };

/* GLSL that writes the word. */
typedef struct {
    const char *fragment; /* writes to location SEEN_TARGET; its main() calls surfaceMain() */
    /* reads seen_place, the index of the object's place: an input if SEEN_INSTANCES is defined,
     * else a uniform */
    bool places;
} SeenText;

/* Texts for the programs of a set; `text` is NULL if programs write no such word. */
typedef struct {
    const SeenText *text;
    const char *head;
    char defined[SEEN_TEXT_DEFINED];
    bool instances;
} SeenTextAround;

void seen_text_make(const GlContext *gl, const MaterialSet *set, const SeenText *text,
                    SeenTextAround *made);
/* Wraps a material's programs, each a single text; *around must live until they are compiled. */
void seen_text_wrap(const SeenTextAround *around, ProgramText *program);
#endif
