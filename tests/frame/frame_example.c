#include "tests/frame/frame_example.h"
#include "compiler/base/file.h"
#include <stdio.h>
#include <stdlib.h>

Scene *frame_example(const char *name, int width, const MatcOptions *options, MatcDocument **document)
{
    char path[256];
    size_t size;
    const char *why;
    Scene *scene = NULL;
    snprintf(path, sizeof path, "examples/scenes/%s.yaml", name);
    char *text = file_read(path, &size, &why);
    if (!text) {
        fprintf(stderr, "%s: %s\n", path, why);
        abort();
    }
    *document = scene_read(path, text, size, options, &scene);
    free(text);
    if (!scene) {
        fprintf(stderr, "%s\n", matc_diagnostics(*document, MATC_TEXT));
        abort();
    }
    scene->height = scene->height * width / scene->width / 2 * 2;
    scene->width = width;
    return scene;
}
