/* Reads reference pictures with the product's picture reader. */
#include "tests/frame_reference/reference_picture.h"
#include "compiler/document.h"
#include "compiler/pipeline.h"
#include <stdio.h>

bool reference_picture_read(const char *name, ReferencePicture *picture)
{
    char text[1024];
    MatcOptions options;
    matc_options_init(&options);
    options.pixels = true;
    const int size =
        snprintf(text, sizeof text,
                 "material: Phong\ndiffuse: { map: ImageMap, image: %s/tests/reference/%s.exr }\n",
                 SOURCE_FOLDER, name);
    *picture =
        (ReferencePicture){.document = matc_read("reference.yaml", text, (size_t)size, &options)};
    const Graph *graph = picture->document->graph;
    if (!graph || graph->image_count != 1 || graph->images[0]->bits != 32)
        return false;
    picture->width = graph->images[0]->width;
    picture->height = graph->images[0]->height;
    picture->rgba = graph->images[0]->texels;
    return true;
}

void reference_picture_free(ReferencePicture *picture) { matc_document_free(picture->document); }
