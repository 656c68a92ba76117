/* Text around the programs of a surface that is traced. Its vertex program runs for each pixel, on
 * attributes where the ray met it, before its fragment program does: so varyings are what they
 * would be there, whatever they are. Changes over the pixel are no differences of neighbours, which
 * may be of another surface. Of
 *
 *     layout(location = 2) in vec2 texcoord;            layout(location = 4) in vec2 uv;
 *     layout(location = 4) out vec2 uv;                 layout(location = 0) out uvec4 fragment0;
 *     void main() { uv = texcoord; ... }                void main() { vec2 uvByX = dFdx(uv); ... }
 *
 * becomes one text with variables `vec2 trace_texcoord, uv, traceX_uv;`, functions
 * traceVertexMain() and traceSurfaceMain(), and the main() of trace_resolve.glsl. */
#ifndef MATC_CACHE_TRACE_TEXT_H
#define MATC_CACHE_TRACE_TEXT_H
#include "compiler/matc.h"

/* Joins two texts of matc, with instances. From malloc; NULL: memory ran out. */
char *trace_text(const MatcProgram *program, const char *vertex, const char *fragment);
#endif
