/* Documents of growth.def that are scenes. */
#include "growth.h"
#include "runtime/scene_reader/scene_read.h"
#include <string.h>

void growth_scene(const char *text, const MatcOptions *options, GrowthRun *run)
{
    Scene *scene;
    MatcDocument *document = scene_read("growth.yaml", text, run->read, options, &scene);
    run->errors += matc_error_count(document);
    run->written += scene ? (size_t)(scene->object_count + scene->light_count +
                                     scene->material_count + scene->motion.key_count)
                          : 0;
    run->written += strlen(matc_diagnostics(document, MATC_TEXT));
    scene_free(scene);
    matc_document_free(document);
}
