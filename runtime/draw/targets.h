/* The render targets of a layout: made in its formats, and bound for who reads them by matc's
 * unpacking GLSL. */
#ifndef MATC_DRAW_TARGETS_H
#define MATC_DRAW_TARGETS_H
#include "compiler/layout/layout.h"
#include "runtime/draw/material.h"
#include "runtime/gl/framebuffer.h"

/* Those that a program of pass gbuffer or plane writes, or those of a layout; spec says their size
 * and depth. False: see gl->error. Delete with framebuffer_delete. */
bool targets_make(GlContext *gl, const MatcProgram *program, const FramebufferSpec *spec,
                  Framebuffer *made);
bool targets_make_layout(GlContext *gl, const LayoutRow *layout, const FramebufferSpec *spec,
                         Framebuffer *made);

/* Puts a program into use that has the unpacking GLSL in it: its samplers matc_gbuffer<i> read
 * target i, from unit 0 on. */
void targets_read(const Framebuffer *targets, Material *reader);
#endif
