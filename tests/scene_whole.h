/* Scenes from texts with their pictures fully loaded, as the renderer needs them; for tests. */
#include "runtime/scene_reader/scene_read.h"
#ifndef TESTS_SCENE_WHOLE_H
#define TESTS_SCENE_WHOLE_H
#include <string.h>

static inline MatcOptions options(void)
{
    MatcOptions made;
    matc_options_init(&made);
    made.pixels = true;
    return made;
}

/* Reads a text that must be a scene. */
static inline Scene *read_scene(const char *text, MatcDocument **document)
{
    const MatcOptions by = options();
    Scene *scene;
    *document = scene_read("scene.yaml", text, strlen(text), &by, &scene);
    if (!scene)
        fail_msg("%s: %s", text, matc_diagnostics(*document, MATC_TEXT));
    return scene;
}

static inline void forget(Scene *scene, MatcDocument *document)
{
    scene_free(scene);
    matc_document_free(document);
}
#endif
