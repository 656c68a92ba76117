/* Pictures of materials: each material is drawn in a preview scene, all with one renderer. */
#ifndef MATC_VIEWER_MATERIAL_PICTURE_H
#define MATC_VIEWER_MATERIAL_PICTURE_H
#include "runtime/viewer/param.h"
#include "runtime/viewer/preview.h"
#include "runtime/viewer/scene_picture.h"

typedef struct {
    /* If no layout is named: the compiler's default layout, or "integer" if `slot` is set. */
    ScenePictureOptions pictures;
    PreviewOptions preview;
    /* G-buffer slot that is shown instead of lighting; its SlotLook exists. NULL: lighting is
     * shown. */
    const char *slot;
    SceneTools tools;    /* overlays to draw */
    const Param *params; /* override the document's defaults */
    int param_count;     /* number of parameters, at most PARAM_LIMIT */
} MaterialPictureOptions;

typedef struct MaterialPictures MaterialPictures;

/* Messages about a material's picture. */
typedef struct {
    char *diagnostics; /* compiler diagnostics, from malloc; NULL: none */
    char error[8192];  /* any other error, or "" */
} MaterialReport;

/* Opens a renderer for materials. Data that the options point to must outlive the result.
 * Returns NULL with the reason in gl->error. */
MaterialPictures *material_pictures_open(GlContext *gl, const MaterialPictureOptions *options);
/* Builds the preview scene of a material, to be drawn next. Returns false on failure: the reason
 * is in reported->diagnostics, or else in reported->error. */
bool material_pictures_show(MaterialPictures *pictures, MatcDocument *document, int material,
                            MaterialReport *reported);
/* Returns the pictures that draw the current preview scene. */
ScenePictures *material_pictures_of(MaterialPictures *pictures);
/* Closes the renderer; NULL is allowed. */
void material_pictures_close(MaterialPictures *pictures);
#endif
