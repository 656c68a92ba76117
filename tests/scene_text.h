/* Scenes from texts, for tests. */
#ifndef MATC_SCENE_TEXT_H
#define MATC_SCENE_TEXT_H
#include "runtime/scene/scene.h"
#include <string.h>

#define RED "materials: { red: { material: RGBA, r: 1 } }\n"

/* The scene of a text; NULL: *document says why. */
static inline Scene *read_text(const char *text, MatcDocument **document)
{
    Scene *scene = NULL;
    MatcOptions options;
    matc_options_init(&options);
    *document = scene_read("scene.yaml", text, strlen(text), &options, &scene);
    return scene;
}

#endif
