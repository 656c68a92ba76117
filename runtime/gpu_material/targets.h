/* The render targets of a layout: textures of its formats, and their binding for readers with
 * matc's unpacking GLSL. */
#ifndef MATC_GPU_MATERIAL_TARGETS_H
#define MATC_GPU_MATERIAL_TARGETS_H
#include "compiler/layout/layout.h"
#include "runtime/gpu_material/material.h"
#include "runtime/gl/framebuffer.h"

/* Makes the targets that a program of pass gbuffer or plane writes, or those of a layout; `spec`
 * has their size and depth. Returns false on failure; see gl->error. Delete with
 * framebuffer_delete(). */
bool targets_make(GlContext *gl, const MatcProgram *program, const FramebufferSpec *spec,
                  Framebuffer *made);
bool targets_make_layout(GlContext *gl, const LayoutRow *layout, const FramebufferSpec *spec,
                         Framebuffer *made);

/* Makes a program with unpacking GLSL current: its samplers matc_gbuffer<i> read target i, from
 * unit 0 on. */
void targets_read(const Framebuffer *targets, Material *reader);
#endif
