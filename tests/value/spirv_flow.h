/* Finds implicit derivatives in the control flow of a SPIR-V module: read from the words, by the
 * specification alone. */
#ifndef MATC_VALUE_SPIRV_FLOW_H
#define MATC_VALUE_SPIRV_FLOW_H
#include <stddef.h>

/* GLSL and SPIR-V leave dFdx, dFdy, fwidth and sampling without an explicit level of detail
 * undefined where invocations of a quad may have taken different branches. This counts every one
 * of them that is
 *
 *     within a selection or a loop, whatever its condition: if (t) c = texture(s, uv);
 *     behind a return or a discard within one:              if (t) discard; c = texture(s, uv);
 *     in a function that is called at such a place:         if (t) c = f(uv);
 *
 * -1: these are no words of a module. *derivatives gets how many there are in all. */
int spirv_conditional_derivatives(const char *words, size_t size, int *derivatives);
/* Counts implicit derivatives in the text of a fragment program, in any version of GLSL, by
 * glslang; returns -1 and prints the reason on standard error if glslang refuses the text. */
int glsl_conditional_derivatives(const char *text, int *derivatives);
#endif
