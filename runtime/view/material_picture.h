/* Pictures of materials: each as its preview's scene, all by one renderer. */
#ifndef MATC_VIEW_MATERIAL_PICTURE_H
#define MATC_VIEW_MATERIAL_PICTURE_H
#include "runtime/view/param.h"
#include "runtime/view/preview.h"
#include "runtime/view/scene_picture.h"

typedef struct {
    /* without a layout it is the compiler's default, of a slot "integer" */
    ScenePictureOptions pictures;
    PreviewOptions preview;
    /* of the G-buffer: it is shown, and no light; there is a look for it. Or NULL */
    const char *slot;
    SceneTools tools;    /* which are drawn */
    const Param *params; /* for uniforms, instead of the document's defaults */
    int param_count;     /* at most PARAM_LIMIT */
} MaterialPictureOptions;

typedef struct MaterialPictures MaterialPictures;

/* Messages about a material. */
typedef struct {
    char *diagnostics; /* of its programs, from malloc; or NULL */
    char error[8192];  /* what else went wrong, or "" */
} MaterialSaid;

/* Opens; data that the options point to must live until the end. NULL: gl->error says why. */
MaterialPictures *material_pictures_open(GlContext *gl, const MaterialPictureOptions *options);
/* Makes a material's scene, which is drawn next. False: see the diagnostics, then the error, which
 * stays empty when they tell it. */
bool material_pictures_show(MaterialPictures *pictures, MatcDocument *document, int material,
                            MaterialSaid *said);
/* That draw it. */
ScenePictures *material_pictures_of(MaterialPictures *pictures);
/* NULL is nothing. */
void material_pictures_close(MaterialPictures *pictures);
#endif
