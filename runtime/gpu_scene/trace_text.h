/* GLSL around the programs of a ray-marched surface. Its vertex program runs for each pixel, on
 * attributes at the hit, before its fragment program: so varyings have exactly the values that a
 * vertex there would have. Derivatives over the pixel are not taken between neighboring pixels,
 * which may show other surfaces. The programs
 *
 *     layout(location = 2) in vec2 texcoord;            layout(location = 4) in vec2 uv;
 *     layout(location = 4) out vec2 uv;                 layout(location = 0) out uvec4 fragment0;
 *     void main() { uv = texcoord; ... }                void main() { vec2 uvByX = dFdx(uv); ... }
 *
 * become one text with variables `vec2 trace_texcoord, uv, traceX_uv;`, functions
 * traceVertexMain() and traceSurfaceMain(), and the main() of trace_resolve.glsl. */
#ifndef MATC_GPU_SCENE_TRACE_TEXT_H
#define MATC_GPU_SCENE_TRACE_TEXT_H
#include "compiler/matc.h"

/* Joins two texts of matc that use instancing. From malloc; NULL if memory runs out. */
char *trace_text(const MatcProgram *program, const char *vertex, const char *fragment);
#endif
