/* Each model by its text. */
#include "runtime/render/surface_model.h"

extern const char render_text_surface_phong[];

const SurfaceModel surface_model_phong = {"Phong", render_text_surface_phong, true};
